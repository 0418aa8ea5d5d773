// Finds plugins (shared objects) and adds their nodes to a registry.
//
// No plugin code is ever loaded into this process: listings (registry/describe.h) and calls of
// build() (registry/plugin_code.h) come from another process. A plugin that crashes or hangs while
// it is loaded is refused like any other.
#pragma once

#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "registry/probe.h"
#include "registry/registry.h"

namespace wrinkle {

struct PluginReport {
    enum class State : uint8_t { found, refused };  // found: its nodes are in the registry
    std::string path;
    std::string id{};  // "" if not yet known when it was refused
    std::string version{};
    std::vector<std::string> nodes{};
    State state = State::refused;
    bool by_manifest = false;  // found without running its code
    std::string why{};         // reason of a refusal, in one or more sentences

    bool is_taken() const { return state != State::refused; }
};

// Returns locations 1 and 2: `options` are the --plugin-path values, `environment` the value of
// WRINKLE_PLUGIN_PATH or null.
//
// Search locations, in order:
//   1. every --plugin-path, as given
//   2. the entries of WRINKLE_PLUGIN_PATH, separated by ':'
//   3. the user's folder, $XDG_DATA_HOME/wrinkle/plugins (~/.local/share/wrinkle/plugins)
//   4. the system's folder, lib/wrinkle/plugins of the installation
// 3 and 4 are skipped if missing, and if WRINKLE_NO_DEFAULT_PLUGINS is set and not empty. A graph
// cannot name a location or load code.
//
// A location is a file or a folder; the *.so files of a folder are loaded in the order of their
// names, without subfolders. A file found twice is loaded once. If two plugins have the same id or
// a node with the same id, the first in this order is used; a built-in node always takes
// precedence. The other plugin is refused completely, and both paths are reported.
std::vector<std::string> plugin_places(std::span<const std::string> options,
                                       const char* environment);
// Returns the readable folders of locations 3 and 4.
std::vector<std::string> default_plugin_folders();
// Returns all four; reads the environment.
std::vector<std::string> plugin_places(std::span<const std::string> options);

// Returns $XDG_CACHE_HOME/wrinkle/plugins (~/.cache/wrinkle/plugins); empty without a home folder.
std::filesystem::path plugin_cache();

struct PluginOptions {
    // Loads a copy of each file, so the file itself may be rewritten and loaded again while the
    // program runs. A file that loads only from its original path is loaded from there.
    bool copies = false;
    // With `copies`: nodes that this registry has from a file that is now refused are retained.
    const Registry* former = nullptr;
    std::filesystem::path cache{};  // folder for results of probes; empty: none
    std::chrono::milliseconds limit = probe_limit;
};

// A refused plugin is an error if its file or location was named, a warning if it was found in a
// folder; the other plugins are still loaded.
std::vector<PluginReport> load_plugins(Registry& registry, std::span<const std::string> places,
                                       Diagnostics& diagnostics, const PluginOptions& options = {});

// Output of `wrinkle plugins`.
std::string to_text(std::span<const PluginReport> reports);

}  // namespace wrinkle
