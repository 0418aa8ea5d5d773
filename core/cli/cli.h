// The `wrinkle` program: one file per command, each declared by one function.
//
// declare_X() adds the options of a command to the parser and sets `run` when the command is
// chosen; run() returns the exit code. Errors go to standard error, results to standard output or
// to files that are written atomically.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>
#include <string>
#include <vector>

namespace wrinkle::cli {

enum ExitCode : int {
    exit_success = 0,
    exit_input = 1,        // an input has errors or cannot be read
    exit_usage = 2,        // wrong usage
    exit_environment = 3,  // an output cannot be written, no GL
};

using Run = std::function<int()>;

void declare_check(CLI::App& app, Run& run);
void declare_compile(CLI::App& app, Run& run);
void declare_eval(CLI::App& app, Run& run);
void declare_render(CLI::App& app, Run& run);
void declare_bake(CLI::App& app, Run& run);
void declare_convert(CLI::App& app, Run& run);
void declare_lint(CLI::App& app, Run& run);
void declare_test(CLI::App& app, Run& run);
void declare_format(CLI::App& app, Run& run);
void declare_upgrade(CLI::App& app, Run& run);
void declare_inputs(CLI::App& app, Run& run);
void declare_nodes(CLI::App& app, Run& run);
void declare_plugins(CLI::App& app, Run& run);
void declare_new_plugin(CLI::App& app, Run& run);
void declare_explain_log(CLI::App& app, Run& run);
void declare_completion(CLI::App& app, Run& run);
void declare_man(CLI::App& app, Run& run);

// Implementation of main(): parses the command line, runs the command, returns the exit code.
int run_cli(int argc, const char* const* argv);

}  // namespace wrinkle::cli
