// What the commands that read graphs share: their options, the node types, the project.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/cli.h"
#include "graph/subgraph.h"
#include "lower/override.h"
#include "registry/plugin_loader.h"
#include "registry/registry.h"

namespace wrinkle::cli {

struct CommonOptions {
    std::vector<std::string> set;
    std::string root;
    std::vector<std::string> plugin_paths;
    bool no_tangents = false;
    std::string diagnostics = "text";
};

void declare_plugin_path(CLI::App& command, CommonOptions& options);
void declare_common(CLI::App& command, CommonOptions& options, bool with_set = true);

// The built-in nodes and those of plugins. Plugins are looked for once a process.
struct Nodes {
    Registry registry;
    std::vector<PluginReport> plugins;
};
Nodes load_nodes(const CommonOptions& options, Diagnostics& diagnostics);

// The folder of a stream, such as "-", is the working folder.
Project open_project(const std::string& file, const CommonOptions& options,
                     Diagnostics& diagnostics);

// The whole of a file that the user names, or of a stream; nothing with an error.
std::optional<std::string> read_text(const std::string& file, Diagnostics& diagnostics);

// A problem at a value. Those beyond the list's limit are only counted: finding the pointer of an
// item takes a walk over its array.
void report_at(const json::Value& value, std::string message, std::string expected,
               Diagnostics& diagnostics);

// The values of --set. Sweeps run side by side: their lengths must agree.
struct Overrides {
    std::vector<Override> list;
    size_t runs = 1;
    bool is_sweep() const { return runs > 1; }
};
Overrides parse_overrides(const CommonOptions& options, Diagnostics& diagnostics);

// OUT with ".003" before its extension for run 3 of a sweep, else OUT.
std::string path_of_run(const std::string& path, const Overrides& overrides, size_t run);

}  // namespace wrinkle::cli
