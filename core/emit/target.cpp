#include "emit/target.h"

#include <algorithm>
#include <array>

#include "emit/language.h"

namespace wrinkle {
namespace {

constexpr std::string_view vulkan = "#version 450";
constexpr std::string_view metal = "#include <metal_stdlib>\nusing namespace metal;";

// GLSL ES has medium or low default precision; bumps, positions and float images need high.
constexpr std::string_view es_precision =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

// Draw buffers: MAX_DRAW_BUFFERS of OpenGL 3.3 and ES 3.0, maxFragmentOutputAttachments of Vulkan
// 1.0, render targets of Direct3D 11 and of Metal, maxColorAttachments of WebGPU.
constexpr std::array<Target, 9> table{{
    {"glsl330", "GLSL 3.30", glsl, Forms::both, "", "#version 330 core", "", "dFdx", "dFdy",
     Bindings::by_name, 8, "OpenGL 3.3 and later"},
    {"glsl450", "GLSL 4.50", vulkan_glsl, Forms::both, "", vulkan, "", "dFdxFine", "dFdyFine",
     Bindings::by_set, 4, "Vulkan: uniforms in blocks, sets, bindings and locations"},
    {"essl300", "GLSL ES 3.00", glsl, Forms::both, "", "#version 300 es", es_precision, "dFdx",
     "dFdy", Bindings::by_name, 4, "WebGL 2 and OpenGL ES 3.0"},
    {"spirv", "SPIR-V", vulkan_glsl, Forms::shader, ".spv", vulkan, "", "dFdxFine", "dFdyFine",
     Bindings::by_set, 4, "SPIR-V 1.0 for Vulkan 1.0, optimised; complete pairs only"},
    {"hlsl", "HLSL", hlsl, Forms::both, ".hlsl", "", "", "ddx_fine", "ddy_fine", Bindings::by_kind,
     8, "Direct3D, shader model 5.0"},
    {"msl", "Metal", msl, Forms::both, ".msl", metal, "", "dfdx", "dfdy", Bindings::by_kind, 8,
     "Metal 2.0"},
    {"wgsl", "WGSL", wgsl, Forms::both, ".wgsl", "", "", "dpdxFine", "dpdyFine", Bindings::by_group,
     8, "WebGPU"},
    {"godot3", "Godot 3", godot3, Forms::function, ".shader", "", "", "dFdx", "dFdy",
     Bindings::by_name, 8, "Godot 3.2 and later, GLES3; functions only"},
    {"godot4", "Godot 4", godot4, Forms::function, ".gdshaderinc", "", "", "dFdx", "dFdy",
     Bindings::by_name, 8, "Godot 4; functions only"},
}};

}  // namespace

std::span<const Target> targets() {
    return table;
}

const Target* find_target(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Target::name);
    return found == table.end() ? nullptr : found;
}

bool is_binary(const Target& target) {
    return target.suffix == ".spv";
}

}  // namespace wrinkle
