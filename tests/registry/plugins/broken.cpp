// Performs the action named by the file: see broken.h.
#include "broken.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>
#include <wrinkle/plugin.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace {

void build(const wr_builder*) {}

// 5000 bytes without terminator; memory behind them is unmapped and must not be read.
const char* const endless = [] {
    static char text[5000];
    std::memset(text, 'a', sizeof text);
    return text;
}();

template <class T>
T* nowhere() {
    static uintptr_t volatile address = 64;
    return reinterpret_cast<T*>(address);
}

void touch_nothing() {
    *nowhere<int volatile>() = 1;
}

void loop() {
    for (;;)
        pause();
}

// Leaves its process group, reports its process id, and holds inherited files open for a while.
void live_outside() {
    const std::string number = std::to_string(getpid());
    const char* mark = std::getenv("WRINKLE_TEST_MARK");
    const int file = mark ? open(mark, O_WRONLY | O_CREAT, 0600) : -1;
    if (write(file, number.data(), number.size()) < 0) _exit(9);
    sleep(60);
    _exit(0);
}

// Starts a process that leaves the group, and waits until it has left.
void escape() {
    int ends[2];
    if (pipe(ends) != 0) _exit(9);
    if (fork() == 0) {
        setsid();
        close(ends[0]);
        close(ends[1]);
        live_outside();
    }
    close(ends[1]);
    char none;
    if (read(ends[0], &none, 1) != 0) _exit(9);
    close(ends[0]);
}

// The files include the pipe to the loading program.
void close_all() {
    for (int file = 0; file < 64; ++file)
        close(file);
}

void say(const char* text) {
    if (write(3, text, std::strlen(text)) < 0) _exit(9);
}

wr_port port(uint32_t kind, uint32_t type, const char* name) {
    wr_port made{};
    made.size = sizeof made;
    made.kind = kind;
    made.type = type;
    made.name = name;
    made.doc = "A port";
    return made;
}

const char* choices[] = {"soft", "hard"};
wr_port input = port(WR_KIND_INPUT, WR_PORT_float, "value");
wr_port mode = port(WR_KIND_CHOICE, 0, "mode");
wr_port image = port(WR_KIND_INPUT, WR_PORT_image, "image");
wr_port field = port(WR_KIND_FIELD, WR_PORT_float, "shape");
wr_port output = port(WR_KIND_OUTPUT, WR_PORT_float, "value");
const wr_port* ports[300] = {&input, &mode, &image, &field, &output};
wr_rename rename_1{sizeof(wr_rename), 2, "size", "value"}, rename_2{};
const wr_rename* renames[300] = {&rename_1, &rename_2};
wr_node node{sizeof(wr_node), 3, "broken", "Broken", "A node.", "test",
             ports,           5, renames,  1,        build};
const wr_node* nodes[10'001] = {&node};
wr_plugin plugin{sizeof(wr_plugin), WR_ABI, "broken", "1", nodes, 1, nullptr};

std::string_view variant() {
    Dl_info info{};
    dladdr(reinterpret_cast<void*>(&build), &info);
    std::string_view name = info.dli_fname ? info.dli_fname : "";
    name.remove_prefix(name.rfind('/') + 1);
    return name.substr(0, name.rfind('.'));
}

// Runs after the variables above are initialised.
__attribute__((constructor(65535))) void load() {
    [[maybe_unused]] const std::string_view name = variant();
#define X(id, change, expected) \
    if (name == #id) {          \
        change;                 \
    }
    BROKEN_LOADING(X)
#undef X
    if (name == "forks" && fork() == 0) loop();
    if (name == "escapes") escape();
}

}  // namespace

extern "C" const wr_plugin* wrinkle_plugin(void) {
    input.default_kind = WR_DEFAULT_CONSTANT;
    input.hard_max = 1;
    mode.choices = choices;
    mode.choice_count = 2;
    const wr_plugin* result = &plugin;
    const std::string_view name = variant();
#define X(id, change, expected) \
    if (name == #id) {          \
        change;                 \
    }
    BROKEN_ENTRY(X)
    BROKEN_PLUGIN(X)
    BROKEN_NODE(X)
    BROKEN_PORT(X)
#undef X
    return result;
}
