// A plugin's C descriptors, read with suspicion into node types; for core/registry alone.
//
// A struct is copied as far as its `size` says; one smaller than the first version of the ABI had
// it is refused. Every fault is a diagnostic at `origin` with the node's id.
#pragma once

#include <string_view>
#include <vector>

#include "registry/registry.h"

namespace wrinkle {

// False when anything is wrong; `types` then holds what could be read.
bool read_descriptors(const wr_plugin* plugin, std::string_view origin,
                      std::vector<NodeType>& types, Diagnostics& diagnostics);

// As a struct is read: zeros where its size ends. Nothing if it is too small for ABI 1.
bool read_plugin(const wr_plugin* plugin, wr_plugin& copy);

}  // namespace wrinkle
