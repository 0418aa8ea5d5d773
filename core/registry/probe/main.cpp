// wrinkle-plugin-probe FILE SHA256: loads one plugin and writes what it offers to file descriptor
// 3, as registry/probe.h says. Started by programs of Wrinkle; of no use by itself.
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <string>

#include "registry/library.h"
#include "registry/probe.h"

namespace {

void write_all(std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = write(wrinkle::probe_output, text.data(), text.size());
        if (count <= 0) _exit(3);
        text.remove_prefix(static_cast<size_t>(count));
    }
}

void say_stage(const char* stage) {
    write_all(std::string(wrinkle::probe_stage) + stage + "\n");
}

// The system's loader lets no exception of a constructor pass.
[[noreturn]] void say_exception() {
    wrinkle::Diagnostics faults;
    if (!std::current_exception()) std::abort();
    wrinkle::add_fault(
        faults, "", "it threw an exception that nothing caught: " + wrinkle::words_of_exception());
    write_all(std::string(wrinkle::probe_refused) + to_json(faults));
    _exit(0);
}

// A crash is to be seen as its signal, leaves no core, and nothing outlives who asked.
void prepare() {
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
        signal(number, SIG_DFL);
    std::set_terminate(say_exception);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    prepare();
    wrinkle::Diagnostics faults;
    auto listing = wrinkle::load_library(argv[1], argv[1], faults, say_stage);
    if (listing) {
        listing->sha256 = argv[2];
        write_all(std::string(wrinkle::probe_fine) + to_json(*listing));
    } else {
        write_all(std::string(wrinkle::probe_refused) + to_json(faults));
    }
    _exit(0);  // without the plugin's destructors
}
