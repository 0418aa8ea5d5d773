// wrinkle plugins --test FILE: holds a plugin's nodes to what the built-in ones are held to
// (core/certify), and prints a report.
//
// Exit code: 1 when anything was found or the plugin is refused; else 3 when the GPU
// check could not be run and --no-gpu did not ask for that; else 0.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace wrinkle::cli {

struct CertifyOptions {
    std::string file;
    bool no_gpu = false;
    std::vector<std::string> allow;    // checks whose findings are meant
    std::string diagnostics = "text";  // json: the findings as diagnostics on standard error too
};

void declare_certify(CLI::App& command, CertifyOptions& options);
int certify_plugin(const CertifyOptions& options);

}  // namespace wrinkle::cli
