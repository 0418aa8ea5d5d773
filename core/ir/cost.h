// Cost of a module in a shader, computed without a driver: scalar operations and texture reads.
//
// An operation counts once per component of its result, with the exceptions of docs/cost.md, which
// ir/op_traits.h lists. Constructs, swizzles and columns are free, and so are leaves and screen
// derivatives. The body of a loop counts once, a function at each of its calls. A value that
// several nodes need counts for the node that wrote it first.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "ir/side_tables.h"

namespace wrinkle {

struct Cost {
    uint32_t reads = 0, ops = 0;

    // Saturates, as functions that call each other can double the cost with each level.
    Cost& operator+=(const Cost& other) {
        reads += std::min(other.reads, ~reads);
        ops += std::min(other.ops, ~ops);
        return *this;
    }
    bool operator==(const Cost&) const = default;
};

// Returns the cost of all instructions that the outputs of an expanded module need, by index in
// Module::nodes.
std::vector<Cost> cost_by_node(const Module& module);

}  // namespace wrinkle
