// What a muted node does: each output passes on an input of its own type, the first that a wire
// leads to, else the first.
#pragma once

#include <cstdint>

#include "registry/registry.h"

namespace wrinkle {

// `is_connected(port)` says whether a wire leads to an input. NodeType::none where the output's
// type has no input. Both are indices in NodeType::ports.
template <class IsConnected>
uint32_t passed_input(const NodeType& type, uint32_t output, IsConnected is_connected) {
    uint32_t first = NodeType::none;
    for (uint32_t p = 0; p < type.ports.size(); ++p) {
        if (!type.ports[p].is_value() || type.ports[p].type != type.ports[output].type) continue;
        if (is_connected(p)) return p;
        if (first == NodeType::none) first = p;
    }
    return first;
}

}  // namespace wrinkle
