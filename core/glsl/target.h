// The shading languages that a module can be written in, one table row each.
//
// A row with a suffix is no GLSL: emit() writes the text that it is made from, which core/spirv
// translates. Such a target exists as a complete pair alone.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace wrinkle {

// How a caller finds uniforms and images.
//   by_name   each is a uniform of its own
//   by_set    Vulkan: uniforms stand in blocks; blocks, then images, are numbered in one set
//   by_kind   blocks as there; blocks and images are numbered for themselves: register(bN), (tN)
//             and (sN) of HLSL, [[buffer(N)]], [[texture(N)]] and [[sampler(N)]] of Metal
enum class Bindings : uint8_t { by_name, by_set, by_kind };

struct Target {
    std::string_view name;       // "glsl330", as --target takes it
    std::string_view label;      // "GLSL 3.30", for people
    std::string_view suffix;     // of its files behind ".vert" and ".frag"; "" for GLSL
    std::string_view version;    // first line of a complete shader
    std::string_view precision;  // lines that must stand before fragment code; may be empty
    std::string_view change_x;   // the functions that give the change to the next pixel
    std::string_view change_y;
    Bindings bindings;
    uint32_t draw_buffers;  // that every machine has for the outputs of a fragment shader
    std::string_view doc;
};

std::span<const Target> targets();  // the first is the default
const Target* find_target(std::string_view name);

// Whether there is a complete pair only.
inline bool is_translated(const Target& target) {
    return !target.suffix.empty();
}

}  // namespace wrinkle
