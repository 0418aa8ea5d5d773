// The targets, one table row each: a language (emit/language.h) in one of its versions.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace wrinkle {

// How the application finds uniforms and images.
//   by_name   each is a separate uniform, found by its name
//   by_set    Vulkan: uniforms are in blocks; blocks, then images, are numbered in one set
//   by_group  WebGPU: as by_set; the sampler of an image has the next number
//   by_kind   uniforms are in blocks; blocks and images are numbered separately: register(bN),
//             (tN) and (sN) in HLSL, [[buffer(N)]], [[texture(N)]] and [[sampler(N)]] in Metal
enum class Bindings : uint8_t { by_name, by_set, by_group, by_kind };

// A function, or a complete pair (emit/emit.h); and which of them a target supports.
enum class Form : uint8_t { function, shader };
enum class Forms : uint8_t { both, function, shader };

struct Language;

struct Target {
    std::string_view name;   // "glsl330", as in --target
    std::string_view label;  // "GLSL 3.30", for display
    const Language& (*language)();
    Forms forms;
    std::string_view suffix;     // file suffix, after ".vert", ".frag"; "" for GLSL
    std::string_view version;    // first lines of a complete shader; may be empty
    std::string_view precision;  // lines required before fragment code; may be empty
    std::string_view change_x;   // screen derivative functions: "dFdx", "dFdy"
    std::string_view change_y;
    Bindings bindings;
    uint32_t draw_buffers;  // guaranteed number of fragment outputs
    std::string_view doc;
};

constexpr bool supports(const Target& target, Form form) {
    return target.forms != (form == Form::function ? Forms::shader : Forms::function);
}

constexpr Form default_form(const Target& target) {
    return supports(target, Form::function) ? Form::function : Form::shader;
}

// The suffix of a file with a function.
constexpr std::string_view function_suffix(const Target& target) {
    return target.suffix.empty() ? ".glsl" : target.suffix;
}

std::span<const Target> targets();  // the first is the default
const Target* find_target(std::string_view name);

// Returns true if the target is compiled from GLSL 4.50 by core/spirv.
bool is_binary(const Target& target);

}  // namespace wrinkle
