// wrinkle plugins --test FILE: tests a plugin's nodes for the properties of the built-in nodes
// (core/certify), and prints a report.
//
// Exit code: 1 if there are findings or the plugin is refused; else 3 if the GPU check could not
// run and --no-gpu was not given; else 0.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace wrinkle::cli {

struct CertifyOptions {
    std::string file;
    bool no_gpu = false;
    std::vector<std::string> allow;    // checks with suppressed findings
    std::string diagnostics = "text";  // json: the findings as diagnostics on standard error too
};

void declare_certify(CLI::App& command, CertifyOptions& options);
int certify_plugin(const CertifyOptions& options);

}  // namespace wrinkle::cli
