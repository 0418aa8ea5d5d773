// Listing of a plugin: its names and the complete descriptors of its nodes, without code.
//
// Read from the code once, in a separate process, and stored as JSON next to the plugin (a
// manifest) or in the cache, with the hash of the file that it describes. A stored listing passes
// the same checks as the descriptors of a plugin; a damaged one is refused.
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
    std::string sha256;  // hash of the file
    std::vector<NodeType> types;
};

// Canonical: equal listings give equal bytes. `origin` of the types is omitted.
std::string to_json(const PluginListing& listing);

// Returns std::nullopt on any fault. `name` is the file of the text in diagnostics, `origin` that
// of the types, which have no build functions.
std::optional<PluginListing> read_listing(std::string text, const std::string& name,
                                          const std::string& origin, Diagnostics& diagnostics);

// Validates the C descriptors of a plugin and converts them to node types. A struct is copied up to
// its `size`; one smaller than in the first version of the ABI is refused. Every fault is a
// diagnostic at `origin` with the node's id. Returns false on any fault; `types` then holds what
// could be read.
bool read_descriptors(const wr_plugin* plugin, std::string_view origin,
                      std::vector<NodeType>& types, Diagnostics& diagnostics);

// Copies a struct, with zeros after its `size`. Returns false if it is too small for ABI 1.
bool read_plugin(const wr_plugin* plugin, wr_plugin& copy);

}  // namespace wrinkle
