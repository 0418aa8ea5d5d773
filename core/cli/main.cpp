#include <cstdio>

#include "cli/cli.h"
#include "cli/output.h"

// Flushes standard output, because a buffered write may still fail.
int main(int argc, char** argv) {
    using namespace wrinkle::cli;
    const int code = run_cli(argc, argv);
    const bool printed = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (printed || code == exit_environment) return code;
    print_error("standard output cannot be written");
    return exit_environment;
}
