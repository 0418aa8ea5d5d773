// A node with a build() that performs its choice; and a constructor that ends every program except
// the probe.
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wrinkle/plugin.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Deep = uint32_t (*)(const volatile uint32_t*);
extern volatile Deep deeper;

uint32_t deep(const volatile uint32_t* from) {
    volatile uint32_t many[4096];
    many[*from % 4096] = *from;
    return deeper(many) + many[0];
}
volatile Deep deeper = deep;

void overflow_the_stack() {
    const volatile uint32_t start = 1;
    if (deeper(&start) == 0) _exit(9);
}

void loop() {
    volatile bool go_on = true;
    while (go_on) {
    }
}

constexpr size_t much = 64 << 20;

void take_all_memory() {
    for (volatile char* part;;) {
        part = new char[much];
        *part = 1;
    }
}

void take_all_memory_in_c() {
    for (volatile char* part;;) {
        part = static_cast<char*>(std::malloc(much));
        *part = 1;
    }
}

void close_all() {
    for (int file = 0; file < 64; ++file)
        close(file);
}

void print() {
    const char text[] = "a print\n";
    std::fputs(text, stdout);
    std::fflush(stdout);
    for (int file = 1; file < 64; ++file)
        if (file != 3 && write(file, text, sizeof text - 1) > 0) continue;
}

void change_the_process() {
    std::filesystem::current_path("/");
    const rlimit none{0, 0};
    setrlimit(RLIMIT_FSIZE, &none);
    std::signal(SIGPIPE, SIG_DFL);
    umask(0777);
    setenv("TMPDIR", "/nowhere", 1);
}

void emit_without_end(const wr_builder* b) {
    for (wr_value value = b->input(b, 0);;)
        value = b->emit(b, WR_OP_neg, 0, &value, 1, 0);
}

// Many calls, fewer than a node may make: 1 + value + value + ...
wr_value many_calls(const wr_builder* b) {
    const double one = 1;
    wr_value sum = b->literal(b, WR_TYPE_float, &one);
    for (int i = 0; i < 20'000; ++i) {
        const wr_value both[] = {sum, b->input(b, 0)};
        sum = b->emit(b, WR_OP_add, 0, both, 2, 0);
    }
    return sum;
}

// A function of one value, applied to an array that is also its result array.
wr_value alias(const wr_builder* b) {
    const uint32_t type = WR_TYPE_float;
    wr_value value = 0;
    b->begin_region(b, WR_REGION_FUNCTION, "twice", &type, 1, &value);
    const wr_value both[] = {value, value};
    const wr_value sum = b->emit(b, WR_OP_add, 0, both, 2, 0);
    const wr_region twice = b->end_region(b, &sum, 1, 0);
    wr_value in_and_out = b->input(b, 0);
    b->apply(b, twice, &in_and_out, 1, &in_and_out, 1);
    return in_and_out;
}

const char* const ways[] = {"fine",   "ends",    "ends_at_once", "aborts",    "crashes", "recurses",
                            "hangs",  "emits",   "takes_memory", "allocates", "closes",  "prints",
                            "throws", "changes", "forges",       "says_much", "aliases", "many"};

void build(const wr_builder* b) {
    const std::string way = ways[b->option(b, 1)];
    wr_value result = b->input(b, 0);
    if (way == "ends") std::exit(0);
    if (way == "ends_at_once") _exit(0);
    if (way == "aborts") std::abort();
    if (way == "crashes") std::raise(SIGSEGV);
    if (way == "recurses") overflow_the_stack();
    if (way == "hangs") loop();
    if (way == "emits") emit_without_end(b);
    if (way == "takes_memory") take_all_memory();
    if (way == "allocates") take_all_memory_in_c();
    if (way == "closes") close_all();
    if (way == "prints") print();
    if (way == "throws") throw std::runtime_error("thrown\nother.json:1:1: error: forged");
    if (way == "changes") change_the_process();
    if (way == "forges")
        b->error(b,
                 "one\nother.json:1:1: error: two\x1b[2J\xE2\x80\xAE"
                 "end");
    if (way == "says_much") b->error(b, std::string(50'000'000, 'x').c_str());
    if (way == "aliases") result = alias(b);
    if (way == "many") result = many_calls(b);
    b->output(b, 2, result);
}

wr_port port(uint32_t kind, const char* name) {
    wr_port made{};
    made.size = sizeof made;
    made.kind = kind;
    made.type = WR_PORT_float;
    made.name = name;
    made.doc = "A port";
    return made;
}

__attribute__((constructor)) void end_every_other_program() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (program.filename() != "wrinkle-plugin-probe") std::exit(0);
}

}  // namespace

extern "C" WR_EXPORT const wr_plugin* wrinkle_plugin(void) {
    static wr_port input = port(WR_KIND_INPUT, "value"), way = port(WR_KIND_CHOICE, "way"),
                   output = port(WR_KIND_OUTPUT, "value");
    static const wr_port* ports[] = {&input, &way, &output};
    static const wr_node dying{
        sizeof(wr_node), 1, "dying", "Dying", "Does as it is bidden.", "test", ports, 3,
        nullptr,         0, build};
    static const wr_node* nodes[] = {&dying};
    static const wr_plugin plugin{sizeof(wr_plugin), WR_ABI, "dying", "1", nodes, 1, nullptr};
    input.default_kind = WR_DEFAULT_CONSTANT;
    way.choices = ways;
    way.choice_count = sizeof ways / sizeof *ways;
    return &plugin;
}
