// wrinkle watch COMMAND...: runs a command again whenever one of its inputs changes.
#include <array>

#include "cli/cli.h"
#include "cli/output.h"
#include "cli/watch_loop.h"

namespace wrinkle::cli {
namespace {

constexpr std::array watched_commands = {"check",   "compile", "eval",    "render", "bake",
                                         "convert", "lint",    "compare", "export", "test"};

struct WatchCommand {
    WatchOptions options;
    std::string command;
    bool serve = false;
    int port = 8137;
    const CLI::App* app = nullptr;

    int run() {
        options.words = app->remaining();
        for (size_t i = 0; i < options.words.size(); ++i)
            if (options.words[i] == "-" && (i == 0 || options.words[i - 1] != "-o"))
                return fail(exit_usage, "watch reads files; standard input can be read only once");
        options.words.insert(options.words.begin(), command);
        if (serve) options.port = port;
        return watch(options);
    }
};

}  // namespace

void declare_watch(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<WatchCommand>(app, run, "watch", "Runs a command again when an input changes");
    c.app = &sub;
    sub.prefix_command();
    add_choice(sub, "COMMAND", c.command, watched_commands,
               "The command, followed by its options and files")
        ->required();
    sub.add_flag("--poll", c.options.poll,
                 "Looks at the files ten times a second, for file systems that report no changes");
    CLI::Option* serve =
        sub.add_flag("--serve", c.serve,
                     "Shows outputs and errors on a page of this machine, http://localhost:PORT");
    sub.add_option("--port", c.port, "The port of that page; 0 takes a free one")
        ->type_name("PORT")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str()
        ->needs(serve);
}

}  // namespace wrinkle::cli
