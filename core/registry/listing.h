// What a plugin offers, without its code: its names and the whole descriptors of its nodes.
//
// Read from the code once, by a process of its own, and kept as JSON beside the plugin (a manifest)
// or in the cache, with the sum of the file that it describes. A listing that is read back goes
// through the same checks as the descriptors of a plugin: a damaged one is refused, never believed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "registry/registry.h"

namespace wrinkle {

struct PluginListing {
    std::string id;
    std::string version;
    std::string sha256;  // of the file
    std::vector<NodeType> types;
};

// Canonical: equal listings are equal bytes. `origin` of the types is left out.
std::string to_json(const PluginListing& listing);

// Nothing when anything is wrong. `name` is the text's file in diagnostics, `origin` that of the
// types, which come without build functions.
std::optional<PluginListing> read_listing(std::string text, const std::string& name,
                                          const std::string& origin, Diagnostics& diagnostics);

}  // namespace wrinkle
