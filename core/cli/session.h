// Options and loading that the commands on graphs share: node types, project, --preset and --set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/output.h"
#include "graph/subgraph.h"
#include "lower/override.h"
#include "registry/plugin_loader.h"
#include "registry/registry.h"

namespace CLI {
class App;
}

namespace wrinkle::cli {

struct CommonOptions {
    std::vector<std::string> presets;  // applied in this order, before `set`
    std::vector<std::string> set;
    std::string root;
    std::vector<std::string> plugin_paths;
    bool no_tangents = false;
    std::string diagnostics = "text";
};

void declare_plugin_path(CLI::App& command, CommonOptions& options);
void declare_common(CLI::App& command, CommonOptions& options, bool with_set = true);

// Built-in nodes and plugin nodes. load_nodes() searches the plugin folders on each call.
struct Nodes {
    Registry registry;
    std::vector<PluginReport> plugins;
};
Nodes load_nodes(const CommonOptions& options, Diagnostics& diagnostics);

// Loads a graph and its sub-graphs; reports errors. If `file` is a stream such as "-", the files
// that it names are relative to the working folder.
Project open_project(const std::string& file, const CommonOptions& options,
                     Diagnostics& diagnostics);

// NAME.test.json is a regression test (cli/test_case.h) and NAME.preset.json a preset
// (lower/preset.h); both are in the folder of the graph NAME.json, so `*.json` matches them too.
inline constexpr std::string_view test_suffix = ".test.json";

// If `file` is named like a test or a preset, reports an error and returns true.
bool report_no_graph(const std::string& file, Diagnostics& diagnostics);

// Returns the files not named like a test or a preset; reports one warning that lists the others.
// If no file remains, returns all without a warning: reading them reports an error for each.
std::vector<std::string> graphs_among(const std::vector<std::string>& files,
                                      Diagnostics& diagnostics);

// Reads a complete file or stream; returns std::nullopt and reports an error on failure.
std::optional<std::string> read_text(const std::string& file, Diagnostics& diagnostics);

// Reports a problem at a JSON value. After the limit of the list it only counts problems, because
// computing a JSON pointer takes O(array length).
void report_at(const json::Value& value, RuleId rule, std::string message, std::string expected,
               Diagnostics& diagnostics, Severity severity = Severity::error);

// Values of --preset and --set. All sweeps advance by one value per run, so their lengths must be
// equal.
struct Overrides {
    std::vector<std::string> presets;
    std::vector<Override> list;
    size_t runs = 1;
    bool is_sweep() const { return runs > 1; }
};
Overrides parse_overrides(const CommonOptions& options, Diagnostics& diagnostics);

// Returns the project with the presets, then the values of one run.
Project project_of_run(const Project& project, const Registry& registry, const Overrides& overrides,
                       size_t run, Diagnostics& diagnostics);

// Returns the paths of all files that a graph reads (compile/inputs.h).
std::vector<std::string> input_paths(const Project& project, const Registry& registry);

// Returns `path` with ".003" inserted before the extension for run 3 of a sweep, else `path`.
std::string path_of_run(const std::string& path, const Overrides& overrides, size_t run);

}  // namespace wrinkle::cli
