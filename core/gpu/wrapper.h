// Generates the vertex and fragment shader around a material's source, one pair per view. The
// wrapper's names begin with WrView_. In compile logs the material's lines have their own numbers
// and the wrapper's lines after them begin at 100001.
//
// Vertex attributes are those of emit/attributes.h, followed by the drawn position of the vertex.
// The only fragment output is WrView_color.
#pragma once

#include <string>
#include <string_view>

#include "emit/attributes.h"
#include "emit/emit.h"
#include "gpu/renderer.h"

namespace wrinkle::gpu {

struct ShaderText {
    std::string vertex;
    std::string fragment;
};

// `against` may be null: the un-bumped surface. Precondition of the height view: the material has
// the output `height`.
ShaderText wrap_material(const Shader& material, View view, const OutputInfo* against,
                         const Shading& shading = {});

const OutputInfo* find_output(const Shader& material, const std::string& output);

// Returns the GLSL of `vec3 WrView_display(vec3 radiance)`, the display curve of the shaded view,
// with its uniform WrView_exposure.
std::string_view display_text();

// Location of the drawn position; it differs from the position attribute on displaced meshes.
inline constexpr int drawn_location = attribute_count;

}  // namespace wrinkle::gpu
