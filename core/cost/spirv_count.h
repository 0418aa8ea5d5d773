// What a SPIR-V module costs by the rule of docs/cost.md: every instruction of every function once,
// also in loops. The module is one that `spirv-opt -O` has left: no call may remain.
//
//   alu            numbers computed: arithmetic, comparison, choice, logic, bits and conversion the
//                  lanes of their result; dot of n 2n-1; a matrix of c columns and r rows times a
//                  vector (2c-1)r; clamp and fma 2 a lane, mix 3, smoothstep 7, pow 3, cross 9,
//                  length 2n, distance 3n, normalize 3n
//   transcendental sqrt, exp, sin ... a lane, 1 of a length or normalize, 2 a lane of pow
//   divisions      divided lanes; these two are in alu too
//   reads          samples, fetches, gathers and reads of images
//   queries        questions about an image
//   derivatives    of the screen: instructions; derivative_lanes: the numbers they give
//   branches       conditional ones; loops: loops
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
    bool operator==(const ShaderCost&) const = default;
};

struct SpirvCount {
    ShaderCost total;
    std::vector<ShaderCost> lines;  // [i]: of source line i, by OpLine; [0]: of no line
};

// Nothing, with the reason in `why`, for what is no module or has a call left.
std::optional<SpirvCount> count_spirv(std::span<const uint32_t> words, std::string& why);

}  // namespace wrinkle
