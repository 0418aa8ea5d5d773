// Validates the C descriptors of a plugin and converts them to node types; private to
// core/registry.
//
// A struct is copied up to its `size`; a struct smaller than in the first version of the ABI is
// refused. Every fault is a diagnostic at `origin` with the node's id.
#pragma once

#include <string_view>
#include <vector>

#include "registry/registry.h"

namespace wrinkle {

// Returns false on any fault; `types` then holds the node types that could be read.
bool read_descriptors(const wr_plugin* plugin, std::string_view origin,
                      std::vector<NodeType>& types, Diagnostics& diagnostics);

// Copies a struct, with zeros after its `size`. Returns false if it is too small for ABI 1.
bool read_plugin(const wr_plugin* plugin, wr_plugin& copy);

}  // namespace wrinkle
