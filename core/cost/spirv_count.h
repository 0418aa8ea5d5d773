// Counts the cost of a SPIR-V module by the rules of docs/cost.md: every instruction of every
// function; in a loop `i < n` of a constant n, n times. Precondition: optimised by `spirv-opt -O`,
// no call remains.
//
// Written by hand, because no linked library counts operations: SPIRV-Tools would only replace the
// loop over the words, and is in a module that is loaded on demand.
//
//   alu            scalar operations: arithmetic, comparison, selection, logic, bit operations and
//                  conversion: 1 per component of the result; dot of n components 2n-1; a matrix of
//                  c columns and r rows times a vector (2c-1)r; clamp and fma 2 per component, mix
//                  3, smoothstep 7, pow 3; cross 9, length 2n, distance 3n, normalize 3n
//   transcendental sqrt, exp, sin ...: 1 per component; length, distance, normalize: 1; pow: 2 per
//                  component
//   divisions      components divided; divisions and transcendental are also included in alu
//   reads          samples, fetches, gathers and reads of images
//   queries        image queries (size, levels, ...)
//   derivatives    screen derivative instructions; derivative_lanes: components of their results
//   branches       conditional branches and switches; loops: loops. Each once, also in a loop
//
// Loads, stores, extraction, construction and constants are free.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wrinkle {

struct ShaderCost {
    uint32_t alu = 0, transcendental = 0, divisions = 0, reads = 0, queries = 0;
    uint32_t derivatives = 0, derivative_lanes = 0, branches = 0, loops = 0;

    ShaderCost& operator+=(const ShaderCost& other);
    ShaderCost times(uint32_t iterations) const;
    bool operator==(const ShaderCost&) const = default;
};

struct SpirvCount {
    ShaderCost total;
    ShaderCost once;                // the total with every instruction of a loop counted once
    std::vector<ShaderCost> lines;  // [i]: source line i, by OpLine; [0]: no line
};

// Returns std::nullopt and sets `why` if `words` is not a SPIR-V module or contains a call.
std::optional<SpirvCount> count_spirv(std::span<const uint32_t> words, std::string& why);

}  // namespace wrinkle
