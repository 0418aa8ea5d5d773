// Finds plugins (shared objects) and adds them to a registry.
//
// Places, in this order: every --plugin-path as given, then the entries of WRINKLE_PLUGIN_PATH,
// separated by ':'. A place is a file or a folder; of a folder the *.so files are tried in the
// order of their names, folders below are not searched. A file met twice is loaded once. Loaded
// plugins stay loaded until the program ends. One that is cut short, as while it is being written,
// is refused.
//
// A refused plugin is an error when its file or place was named, a warning when it was found in a
// folder; the other plugins are loaded all the same.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "registry/registry.h"

namespace wrinkle {

struct PluginReport {
    enum class State : uint8_t { loaded, refused };
    std::string path;
    std::string id;  // "" when it did not come so far
    std::string version;
    std::vector<std::string> nodes;
    State state = State::refused;
    std::string why;  // of a refused one, in one or more sentences
};

// `options` are the --plugin-path values, `environment` the value of WRINKLE_PLUGIN_PATH or null.
std::vector<std::string> plugin_places(std::span<const std::string> options,
                                       const char* environment);

struct PluginOptions {
    // Loads a copy of each file, which is removed at once: the file itself may be written anew and
    // loaded again while the program runs. One that only loads in its place is loaded there.
    bool copies = false;
};

std::vector<PluginReport> load_plugins(Registry& registry, std::span<const std::string> places,
                                       Diagnostics& diagnostics, const PluginOptions& options = {});

// What `wrinkle plugins` prints.
std::string to_text(std::span<const PluginReport> reports);

}  // namespace wrinkle
