#include "cli/cli.h"

#include <algorithm>

#include "base/diagnostics.h"
#include "base/printable.h"
#include "cli/arguments.h"
#include "cli/output.h"

namespace wrinkle::cli {
namespace {

constexpr const char* version = "wrinkle " WRINKLE_VERSION;

int guarded(const Run& run) {
    try {
        return run();
    } catch (...) {
        print_error(exception_text());
    }
    return exit_environment;
}

// Formats a parse error on one line. It is escaped, because it may quote a file name expanded from
// a shell pattern.
std::string one_line_failure(const CLI::App* app, const CLI::Error& error) {
    const std::string sentence = printable(error.what());
    return CLI::FailureMessage::simple(
        app, CLI::Error(error.get_name(), sentence, error.get_exit_code()));
}

}  // namespace

int run_cli(int argc, const char* const* argv) {
    CLI::App app("Layered bump mapping: graphs to GLSL, pictures and numbers.", "wrinkle");
    app.set_version_flag("--version", version);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    app.footer("Sizes have limits, which environment variables change: `wrinkle man` lists them.");
    app.failure_message(one_line_failure);
    Run run;
    for (auto declare : {declare_check, declare_compile, declare_eval, declare_render, declare_bake,
                         declare_convert, declare_lint, declare_test, declare_format,
                         declare_upgrade, declare_inputs, declare_nodes, declare_plugins,
                         declare_new_plugin, declare_explain_log, declare_completion, declare_man})
        declare(app, run);
    std::string why;
    auto words = command_words(argc, argv, why);
    if (!words) {
        print_error(why);
        return exit_usage;
    }
    std::reverse(words->begin(), words->end());  // CLI11 expects the words in reverse order
    try {
        app.parse(std::move(*words));
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error);
        return code == exit_success || code == exit_environment ? code : int{exit_usage};
    }
    return guarded(run);
}

}  // namespace wrinkle::cli
