// Finds plugins (shared objects) and adds their nodes to a registry.
//
// Places, in this order:
//   1. every --plugin-path, as given
//   2. the entries of WRINKLE_PLUGIN_PATH, separated by ':'
//   3. the user's folder, $XDG_DATA_HOME/wrinkle/plugins (~/.local/share/wrinkle/plugins)
//   4. the system's folder, lib/wrinkle/plugins of the installation
// 3 and 4 are left out where they are missing, and where WRINKLE_NO_DEFAULT_PLUGINS is set to
// anything but "". A graph names no place and loads no code.
//
// A place is a file or a folder; of a folder the *.so files are tried in the order of their names,
// folders below are not searched. A file met twice is taken once. Of two plugins of one id, or two
// that have a node of one id, the first in this order is taken; so is a built-in node. The other is
// refused as a whole, with both paths.
//
// No code of a plugin is ever loaded into this process: what it offers (registry/describe.h) and
// what its nodes do (registry/plugin_code.h) comes from another. A plugin that crashes or hangs
// while it is loaded is refused like any other.
//
// A refused plugin is an error when its file or place was named, a warning when it was found in a
// folder; the other plugins are taken all the same.
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
    std::string id;  // "" when it did not come so far
    std::string version;
    std::vector<std::string> nodes;
    State state = State::refused;
    bool by_manifest = false;  // found without any of its code run
    std::string why;           // of a refused one, in one or more sentences

    bool is_taken() const { return state != State::refused; }
};

// Places 1 and 2: `options` are the --plugin-path values, `environment` the value of
// WRINKLE_PLUGIN_PATH or null.
std::vector<std::string> plugin_places(std::span<const std::string> options,
                                       const char* environment);
// Places 3 and 4, as far as they can be read.
std::vector<std::string> default_plugin_folders();
// All four, by the environment.
std::vector<std::string> plugin_places(std::span<const std::string> options);

// $XDG_CACHE_HOME/wrinkle/plugins (~/.cache/wrinkle/plugins); empty without a home.
std::filesystem::path plugin_cache();

struct PluginOptions {
    // Keeps a copy of each file: the file itself may be written anew and loaded again while the
    // program runs. One that only loads in its place is loaded there.
    bool copies = false;
    // With `copies`: what this registry has of a file that is refused now is kept.
    const Registry* former = nullptr;
    std::filesystem::path cache{};  // where findings of probes are kept; empty: nowhere
    std::chrono::milliseconds limit = probe_limit;
};

std::vector<PluginReport> load_plugins(Registry& registry, std::span<const std::string> places,
                                       Diagnostics& diagnostics, const PluginOptions& options = {});

// What `wrinkle plugins` prints.
std::string to_text(std::span<const PluginReport> reports);

}  // namespace wrinkle
