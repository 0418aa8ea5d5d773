// Writes results to files and standard output, and problems to standard error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/text.h"

namespace wrinkle::cli {

enum ExitCode : int {
    exit_success = 0,
    exit_input = 1,        // an input has errors or cannot be read
    exit_usage = 2,        // wrong usage
    exit_environment = 3,  // an output cannot be written, no GL
};

// Writes files atomically, and standard output if a path is "-"; files first. No file is replaced
// before all temporary files are written. Returns exit_success, or exit_environment after printing
// the reason.
struct Result {
    std::string path, text;
};
int write_results(const std::vector<Result>& results);
int write_result(const std::string& path, std::string text);
// Prints nothing; returns false and the reason in `why` on failure.
bool write_results(const std::vector<Result>& results, std::string& why);

// The formats of problems, for --diagnostics.
inline const std::vector<std::string> diagnostic_formats = {"text", "json", "sarif", "github"};

// Returns the problems in one of diagnostic_formats.
std::string formatted(const Diagnostics& diagnostics, const std::string& format);

// Prints the problems to standard error in one of diagnostic_formats. Returns exit_input if there
// are errors, otherwise exit_success.
int report(const Diagnostics& diagnostics, const std::string& format);

// Prints one sentence to standard error, escaped by printable().
void print_error(std::string_view sentence);
// Prints the sentence and returns `code`.
int fail(ExitCode code, std::string_view sentence);

}  // namespace wrinkle::cli
