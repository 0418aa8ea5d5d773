// Diagnostics as SARIF 2.1.0 (OASIS), for code scanning such as GitHub's.
//
// Every rule of base/rules.h is listed. A diagnostic of a file is a result: its path as a URI
// relative to the repository's root, its line (1 if it is of the file in general) and column, and a
// fingerprint of rule, URI, node and JSON pointer, with a number if equal, which remains when lines
// move. A diagnostic without a file is a notification of the run, as a result without a location is
// not shown.
#pragma once

#include <filesystem>
#include <string>

#include "base/diagnostics.h"

namespace wrinkle::report {

struct SarifOptions {
    std::string version;         // the program's: "1.2.0"
    std::filesystem::path root;  // the repository's (repository.h)
};

// Messages are cut at 1024 characters, GitHub's limit.
std::string sarif(const Diagnostics& diagnostics, const SarifOptions& options);

}  // namespace wrinkle::report
