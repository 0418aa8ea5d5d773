// The target shading languages, one table row each.
//
// A row with a suffix is not GLSL: emit() writes the GLSL that core/spirv translates to it. Such a
// target supports only complete vertex and fragment pairs.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace wrinkle {

// How the application finds uniforms and images.
//   by_name   each is a separate uniform, found by its name
//   by_set    Vulkan: uniforms are in blocks; blocks, then images, are numbered in one set
//   by_kind   uniforms are in blocks; blocks and images are numbered separately: register(bN),
//             (tN) and (sN) in HLSL, [[buffer(N)]], [[texture(N)]] and [[sampler(N)]] in Metal
enum class Bindings : uint8_t { by_name, by_set, by_kind };

struct Target {
    std::string_view name;       // "glsl330", as in --target
    std::string_view label;      // "GLSL 3.30", for display
    std::string_view suffix;     // file suffix after ".vert" and ".frag"; "" for GLSL
    std::string_view version;    // first line of a complete shader
    std::string_view precision;  // lines required before fragment code; may be empty
    std::string_view change_x;   // screen derivative functions: "dFdx", "dFdy"
    std::string_view change_y;
    Bindings bindings;
    uint32_t draw_buffers;  // guaranteed number of fragment outputs
    std::string_view doc;
};

std::span<const Target> targets();  // the first is the default
const Target* find_target(std::string_view name);

// Returns true if the target supports only complete pairs, translated by core/spirv.
inline bool is_translated(const Target& target) {
    return !target.suffix.empty();
}

}  // namespace wrinkle
