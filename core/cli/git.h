// Runs Git, for the commands that work with its repositories.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::cli {

struct GitResult {
    int code = -1;  // exit code of git; -1: it cannot be started or was ended by a signal
    std::string output;
};
// Standard input is empty; standard error of git is discarded.
GitResult run_git(const std::vector<std::string>& words);

// Reads a file, a stream, or, if no such file exists, REVISION:PATH of the repository of the
// working folder. Reports an error and returns std::nullopt on failure.
std::optional<std::string> read_operand(const std::string& name, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
