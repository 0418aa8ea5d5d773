#include "cli/cli.h"

#include <algorithm>
#include <cstdio>

#include "base/diagnostics.h"
#include "base/printable.h"
#include "cli/arguments.h"
#include "cli/output.h"

namespace wrinkle::cli {
namespace {

int guarded(const Run& run) {
    try {
        return run();
    } catch (...) {
        return fail(exit_environment, exception_text());
    }
}

// Formats a parse error on one line. It is escaped, because it may quote a file name expanded from
// a shell pattern.
std::string one_line_failure(const CLI::App* app, const CLI::Error& error) {
    const std::string sentence = printable(error.what());
    return CLI::FailureMessage::simple(
        app, CLI::Error(error.get_name(), sentence, error.get_exit_code()));
}

constexpr const char* version_text =
    "wrinkle " WRINKLE_VERSION
    "\n"
    "Built by " WRINKLE_BUILD
    "\n"
    "MIT License. The licences of its libraries are in docs/licences.md.";

int parse_and_run(std::vector<std::string> words) {
    CLI::App app("Layered materials: graphs to shaders, engines, images and numbers.", "wrinkle");
    app.set_version_flag("--version", version_text, "Version, build and licence");
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    app.footer("Sizes have limits, which environment variables change: `wrinkle man` lists them.");
    app.failure_message(one_line_failure);
    Run run;
#define WRINKLE_DECLARE(name) declare_##name(app, run);
    WRINKLE_COMMANDS(WRINKLE_DECLARE)
#undef WRINKLE_DECLARE
    std::reverse(words.begin(), words.end());  // CLI11 expects the words in reverse order
    try {
        app.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error);
        return code == exit_success || code == exit_environment ? code : int{exit_usage};
    }
    return guarded(run);
}

}  // namespace

// Flushes standard output, because a buffered write may still fail.
int run_words(std::vector<std::string> words) {
    const int code = parse_and_run(std::move(words));
    const bool printed = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (printed || code == exit_environment) return code;
    return fail(exit_environment, "standard output cannot be written");
}

}  // namespace wrinkle::cli

int main(int argc, char** argv) {
    using namespace wrinkle::cli;
    std::string why;
    auto words = command_words(argc, argv, why);
    return words ? run_words(std::move(*words)) : fail(exit_usage, why);
}
