// wrinkle-plugin-probe list FILE SHA256, or build FILE NODE TWICE OPTION...: loads one plugin and
// writes its listing, or the calls of a node's build(), to file descriptor 3 (see
// registry/probe.h). Started by other programs of Wrinkle; not for direct use.
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include "registry/child.h"
#include "registry/library.h"
#include "registry/probe.h"
#include "registry/recording.h"

namespace {

using wrinkle::Diagnostics;

void write_all(std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = write(wrinkle::probe_output, text.data(), text.size());
        if (count <= 0) _exit(wrinkle::child_has_no_output);
        text.remove_prefix(static_cast<size_t>(count));
    }
}

void say_stage(const char* stage) {
    write_all(std::string(wrinkle::probe_stage) + stage + "\n");
}

void say_refused(const Diagnostics& faults) {
    write_all(std::string(wrinkle::probe_refused) + to_json(faults));
}

void say_exception(const char* where) {
    Diagnostics faults;
    wrinkle::add_fault(faults, "", where + wrinkle::words_of_exception());
    say_refused(faults);
}

// The dynamic loader does not propagate exceptions of constructors.
[[noreturn]] void on_terminate() {
    if (!std::current_exception()) std::abort();
    say_exception("it threw an exception that nothing caught: ");
    _exit(0);
}

void limit(decltype(RLIMIT_CORE) what, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(what, &both);
}

// Crashes must be visible as signals and leave no core; the process must end with its parent.
void prepare() {
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
        signal(number, SIG_DFL);
    std::set_terminate(on_terminate);
    limit(RLIMIT_CORE, 0);
#ifndef WRINKLE_SANITIZED  // a sanitizer reserves terabytes
    limit(RLIMIT_AS, wrinkle::max_child_memory);
#endif
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

[[noreturn]] void on_full() {
    _exit(wrinkle::child_output_too_large);
}

// `words`: index of the node, 1 for two runs, and an option for each port.
void build(const wrinkle::PluginListing& plugin, std::span<const int32_t> words) {
    const auto node = static_cast<size_t>(words[0]);
    if (node >= plugin.types.size()) return;
    const auto run = [&](wrinkle::Recorder& recorder) {
        plugin.types[node].build(recorder.builder());
    };
    wrinkle::Recorder first(words.subspan(2), on_full), recorder(words.subspan(2), on_full);
    say_stage("build");
    try {
        if (words[1] != 0) run(first);
        run(recorder);
    } catch (...) {
        return say_exception("its build() threw an exception: ");
    }
    write_all(wrinkle::probe_fine);
    write_all(recorder.calls());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    prepare();
    Diagnostics faults;
    auto plugin = wrinkle::load_library(argv[2], argv[2], faults, say_stage);
    if (!plugin) {
        say_refused(faults);
    } else if (argv[1] == wrinkle::probe_build_word) {
        std::vector<int32_t> words;
        for (int i = 3; i < std::max(argc, 5); ++i)
            words.push_back(i < argc ? std::atoi(argv[i]) : 0);
        build(*plugin, words);
    } else {
        plugin->sha256 = argv[3];
        write_all(std::string(wrinkle::probe_fine) + to_json(*plugin));
    }
    _exit(0);  // skips the plugin's destructors
}
