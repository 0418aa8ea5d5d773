// Writes results to files and standard output, and problems to standard error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::cli {

// Writes a file atomically, or standard output if `path` is "-". Returns false and prints the
// reason on failure (exit code 3).
bool write_result(const std::string& path, std::string_view text);

// Writes several results, files first. No file is replaced before all temporary files are written.
struct Result {
    std::string path, text;
};
bool write_results(const std::vector<Result>& results);
bool write_results(const std::vector<Result>& results, std::string& why);  // prints nothing

// Prints the problems to standard error, as text or as JSON. Returns exit_input if there are
// errors, otherwise exit_success.
int report(const Diagnostics& diagnostics, const std::string& format);

// Prints one sentence to standard error, escaped by printable().
void print_error(std::string_view sentence);

}  // namespace wrinkle::cli
