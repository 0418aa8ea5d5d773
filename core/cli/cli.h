// Commands of the `wrinkle` program, one file each.
//
// A new command is a row of WRINKLE_COMMANDS, a file that defines its declare_NAME(), and a test.
// declare_NAME() adds the options of the command to the parser and sets `run` when the command is
// chosen; run() returns the exit code. Errors go to standard error, results to standard output or
// to files that are written atomically.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/output.h"

namespace wrinkle::cli {

using Run = std::function<int()>;

// In the order of --help.
#define WRINKLE_COMMANDS(row)                                                                   \
    row(check) row(compile) row(eval) row(render) row(bake) row(convert) row(lint) row(compare) \
        row(import) row(export) row(test) row(diff) row(merge) row(settle) row(textconv)        \
            row(git_setup) row(format) row(upgrade) row(inputs) row(nodes) row(plugins)         \
                row(new_plugin) row(explain_log) row(watch) row(completion) row(man)

#define WRINKLE_DECLARE(name) void declare_##name(CLI::App& app, Run& run);
WRINKLE_COMMANDS(WRINKLE_DECLARE)
#undef WRINKLE_DECLARE

// Parses the words of a command line, runs its command and returns the exit code.
int run_words(std::vector<std::string> words);

// Adds a command to the parser and returns it with its Command, which holds the values of the
// options; Command::run() returns the exit code.
template <class Command>
std::pair<CLI::App&, Command&> add_command(CLI::App& app, Run& run, const char* name,
                                           const char* summary) {
    auto command = std::make_shared<Command>();
    CLI::App& sub = *app.add_subcommand(name, summary);
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
    return {sub, *command};
}

// Adds an option that takes one of `names`; its initial value is the default, "" for none.
template <class Names = std::initializer_list<const char*>>
CLI::Option* add_choice(CLI::App& command, const char* option, std::string& value,
                        const Names& names, const std::string& doc) {
    const std::vector<std::string> list(names.begin(), names.end());
    return command.add_option(option, value, doc)
        ->check(CLI::IsMember(list))
        ->capture_default_str();
}

// Returns the names that an option takes, separated by commas; "" if it takes other values.
inline std::string choices_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();  // "TEXT:{a,b}"
    const size_t open = type.find('{');
    return open == type.npos ? "" : type.substr(open + 1, type.find('}', open) - open - 1);
}

// Adds --diagnostics, the format of report().
inline void declare_diagnostics(CLI::App& command, std::string& format) {
    add_choice(command, "--diagnostics", format, diagnostic_formats, "How problems are printed");
}

}  // namespace wrinkle::cli
