// Where results go.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::cli {

// "-" is standard output; a file is written whole or not at all. False, with the reason printed,
// when it cannot be written (exit code 3).
bool write_result(const std::string& path, std::string_view text);

// Several, files first: none is replaced before all have been written beside their places.
struct Result {
    std::string path, text;
};
bool write_results(const std::vector<Result>& results);
bool write_results(const std::vector<Result>& results, std::string& why);  // prints nothing

// Prints the problems to standard error, as text or as JSON, and gives the exit code they mean.
int report(const Diagnostics& diagnostics, const std::string& format);

// One sentence to standard error, escaped as printable() does.
void complain(std::string_view sentence);

}  // namespace wrinkle::cli
