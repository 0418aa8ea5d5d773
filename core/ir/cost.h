// What a module costs in a shader, counted without a driver: numbers computed and texture reads.
//
// An operation counts a number for each lane of its result; dot of n lanes 2n-1, clamp 2 a lane,
// mix 3, smoothstep 7, pow 3, cross 9, length 2n, normalize 3n, a matrix times a vector 15, times a
// matrix 45, as docs/cost.md counts. Taking apart and putting together is free, and so are leaves
// and screen derivatives. The body of a loop counts once, a function at each of its calls. What
// several nodes need counts for the one that wrote it first.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

struct Cost {
    uint32_t reads = 0, ops = 0;

    Cost& operator+=(const Cost& other) {
        reads += other.reads;
        ops += other.ops;
        return *this;
    }
    bool operator==(const Cost&) const = default;
};

// Of one instruction by itself, without the function or loop that it runs.
Cost own_cost(const Module& module, Id id);

// Of all that the outputs of an expanded module need, by Module::nodes.
std::vector<Cost> cost_by_node(const Module& module);

}  // namespace wrinkle
