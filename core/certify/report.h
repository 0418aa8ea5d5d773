// The result of checking one node: findings with location, compared numbers, tolerance and remedy.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::certify {

struct Finding {
    std::string check;    // name of the check (checks.h)
    std::string port;     // "" if it concerns no single port
    std::string message;  // one sentence without a full stop
    std::string remedy;
    std::string graph;  // JSON of a graph that shows it; "" if none is needed
};

struct Report {
    std::string node;
    std::vector<Finding> findings;
    size_t derivatives = 0;  // numbers with a derivative compared with differences
    size_t kinks = 0;        // skipped: at a jump or a kink
    size_t values = 0;       // checked for precision; a vector counts once
    size_t unstable = 0;     // skipped: 4 ulp of the inputs change them beyond tolerance

    // Adds the finding unless one with the same check and port exists.
    void add(Finding finding);
};

// Returns the finding as a diagnostic at the plugin's file.
Diagnostic to_diagnostic(const Finding& finding, const Report& report, const std::string& file);

}  // namespace wrinkle::certify
