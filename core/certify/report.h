// What was found out about one node: each thing that is wrong, where it shows, both numbers, what
// is allowed, and the remedy.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"

namespace wrinkle::certify {

struct Finding {
    std::string check;    // its name, as above the checks of checks.h
    std::string port;     // "" when no port is at fault
    std::string message;  // one sentence without its end
    std::string remedy;
    std::string graph;  // the text of the graph that shows it; "" when none is needed
};

struct Report {
    std::string node;
    std::vector<Finding> findings;
    size_t derivatives = 0;  // numbers whose derivative was compared with differences
    size_t kinks = 0;        // left out: there is a jump or a kink
    size_t values = 0;       // compared between CPU and GPU, a vector counts once
    size_t unstable = 0;     // left out: four ulp of the inputs change them beyond tolerance

    // One finding a check and port: the first says it.
    void add(Finding finding);
};

// As a diagnostic at the plugin's file.
Diagnostic to_diagnostic(const Finding& finding, const Report& report, const std::string& file);

}  // namespace wrinkle::certify
