// The vertex and fragment shader that the renderer writes round a material's text, one pair per
// view. Everything of its own is called WrView_...; in compile logs the lines of the material keep
// their numbers and the renderer's own after them begin at 100001.
//
// Vertex attributes are those of glsl/attributes.h and behind them the place where a vertex is
// drawn. The fragment's one output is WrView_color.
#pragma once

#include <string>
#include <string_view>

#include "glsl/attributes.h"
#include "gpu/material.h"
#include "gpu/renderer.h"

namespace wrinkle::gpu {

struct ShaderText {
    std::string vertex;
    std::string fragment;
};

struct Shading {
    Lighting lighting = Lighting::ggx;
    bool environment = false;  // a cube WrView_surroundings, else sky and ground

    friend bool operator==(const Shading&, const Shading&) = default;
};

// `against` may be null: the un-bumped surface. For the height view the output must exist.
ShaderText wrap_material(const Material& material, View view, const OutputFunction* against,
                         const Shading& shading = {});

// GLSL: `vec3 WrView_display(vec3 radiance)`, what the shaded view shows of it, with its uniform
// WrView_exposure.
std::string_view display_text();

// A displaced vertex is drawn elsewhere than its position says.
inline constexpr int drawn_location = attribute_count;

bool is_property(std::string_view name);  // of a drawn surface

// The location of a property's vertex attribute, -1 for one that needs none ("view", "facing").
int attribute_location(std::string_view property);

}  // namespace wrinkle::gpu
