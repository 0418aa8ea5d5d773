#include "glsl/target.h"

#include <array>

namespace wrinkle {
namespace {

constexpr std::string_view vulkan = "#version 450";

// GLSL ES has medium or low default precision; bumps, positions and float images need high.
constexpr std::string_view es_precision =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

// Draw buffers: MAX_DRAW_BUFFERS of OpenGL 3.3 and ES 3.0, maxFragmentOutputAttachments of Vulkan
// 1.0, render targets of Direct3D 11 and of Metal.
constexpr std::array<Target, 6> table{{
    {"glsl330", "GLSL 3.30", "", "#version 330 core", "", "dFdx", "dFdy", Bindings::by_name, 8,
     "OpenGL 3.3 and later"},
    {"glsl450", "GLSL 4.50", "", vulkan, "", "dFdxFine", "dFdyFine", Bindings::by_set, 4,
     "Vulkan: uniforms in blocks, sets, bindings and locations"},
    {"essl300", "GLSL ES 3.00", "", "#version 300 es", es_precision, "dFdx", "dFdy",
     Bindings::by_name, 4, "WebGL 2 and OpenGL ES 3.0"},
    {"spirv", "SPIR-V", ".spv", vulkan, "", "dFdxFine", "dFdyFine", Bindings::by_set, 4,
     "SPIR-V 1.0 for Vulkan 1.0, optimised; complete pairs only"},
    {"hlsl", "HLSL", ".hlsl", vulkan, "", "dFdxFine", "dFdyFine", Bindings::by_kind, 8,
     "Direct3D, shader model 5.0; complete pairs only"},
    {"msl", "Metal", ".msl", vulkan, "", "dFdxFine", "dFdyFine", Bindings::by_kind, 8,
     "Metal 2.0; complete pairs only"},
}};

}  // namespace

std::span<const Target> targets() {
    return table;
}

const Target* find_target(std::string_view name) {
    for (const Target& target : table)
        if (target.name == name) return &target;
    return nullptr;
}

}  // namespace wrinkle
