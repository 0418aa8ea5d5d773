#include "cli/cli.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "cli/arguments.h"
#include "cli/output.h"

namespace wrinkle::cli {
namespace {

constexpr const char* version = "wrinkle " WRINKLE_VERSION;

// What the machine cannot give is said in one sentence, like any other problem.
int guarded(const Run& run) {
    try {
        return run();
    } catch (const std::bad_alloc&) {
        complain("out of memory");
    } catch (const std::length_error&) {
        complain("out of memory");
    } catch (const std::filesystem::filesystem_error& error) {
        complain(error.path1().string() + ": " + error.code().message());
    } catch (const std::exception& error) {
        complain(error.what());
    }
    return exit_environment;
}

}  // namespace

int run_cli(int argc, const char* const* argv) {
    CLI::App app("Layered bump mapping: graphs to GLSL, pictures and numbers.", "wrinkle");
    app.set_version_flag("--version", version);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    Run run;
    for (auto declare : {declare_check, declare_compile, declare_eval, declare_render, declare_test,
                         declare_format, declare_upgrade, declare_inputs, declare_nodes,
                         declare_plugins, declare_new_plugin, declare_completion, declare_man})
        declare(app, run);
    std::string why;
    auto words = command_words(argc, argv, why);
    if (!words) {
        complain(why);
        return exit_input;
    }
    std::reverse(words->begin(), words->end());  // CLI11 takes them last first
    try {
        app.parse(std::move(*words));
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error);
        return code == exit_fine || code == exit_environment ? code : int{exit_usage};
    }
    return guarded(run);
}

}  // namespace wrinkle::cli
