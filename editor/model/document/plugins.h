// The node types that the editor knows, and reloading of plugins at run time.
//
// Each load creates a registry from copies of the files. Earlier registries and their code stay
// loaded, because documents, jobs and cards may still use their types. Nodes that a plugin no
// longer has are shown and retained like nodes of a missing plugin; if a plugin is broken, its last
// good version remains in use.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "registry/plugin_loader.h"

namespace wrinkle::editor {

struct Session;

struct Plugins {
    std::vector<std::string> places;                          // files and folders
    std::filesystem::path cache;                              // probe results
    std::vector<PluginReport> reports;                        // from the last load
    Diagnostics problems;                                     // from the last load
    std::vector<std::shared_ptr<const Registry>> registries;  // the newest last
};

// Loads the built-in nodes and the plugins; Plugins::problems lists refused ones.
void load_plugins(Session& session);
// Same while the editor runs, with the result in the status.
void reload_plugins(Session& session);

}  // namespace wrinkle::editor
