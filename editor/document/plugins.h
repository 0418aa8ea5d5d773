// The node types that the editor knows, and how plugins are loaded anew while it runs.
//
// Each load makes a registry of its own from copies of the files; former ones stay, with the code
// that they point at, because documents, jobs and cards may still look at their types. What a
// plugin no longer has is shown and kept as nodes of a missing plugin are; of one that is broken
// now the last good version stays in use.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "registry/plugin_loader.h"

namespace wrinkle::editor {

struct State;

struct Plugins {
    std::vector<std::string> places;                          // files and folders
    std::filesystem::path cache;                              // of what probes found
    std::vector<PluginReport> reports;                        // of the last load
    Diagnostics problems;                                     // of the last load
    std::vector<std::shared_ptr<const Registry>> registries;  // the newest last
};

// The built-in nodes and those of the plugins; what was refused, in Plugins::problems.
void load_plugins(State& state);
// The same while the editor runs, with the result in the status.
void reload_plugins(State& state);

}  // namespace wrinkle::editor
