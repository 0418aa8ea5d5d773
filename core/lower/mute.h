// A muted node: each output passes on an input of its own type, the first one with a wire, else the
// first.
#pragma once

#include <cstdint>

#include "registry/registry.h"

namespace wrinkle {

// Returns the input that the output passes on; NodeType::none if no input has the output's type.
// `is_connected(port)` returns true if a wire leads to an input. Both are indices in
// NodeType::ports.
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
