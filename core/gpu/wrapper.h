// Generates the vertex and fragment shader around a material's source, one pair per view. The
// wrapper's names begin with WrView_. In compile logs the material's lines have their own numbers
// and the wrapper's lines after them begin at 100001.
//
// Vertex attributes are those of emit/attributes.h, followed by the drawn position of the vertex.
// The fragment output is WrView_color; in the shaded view, the texels of gpu/surface_values.h.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/attributes.h"
#include "emit/emit.h"
#include "gpu/renderer.h"

namespace wrinkle::gpu {

struct ShaderText {
    std::string vertex, fragment;
    std::vector<std::string> outputs;  // fragment outputs by attachment
};

struct ViewRequest {
    View view = View::shaded;
    const OutputInfo* against = nullptr;  // nullptr: the un-bumped surface
    const OutputInfo* output = nullptr;   // shown by View::output
};

// Precondition of the height view: the material has the output `height`.
ShaderText wrap_material(const Shader& material, const ViewRequest& request);

const OutputInfo* find_output(const Shader& material, const std::string& output);

bool is_height(const OutputInfo& output);  // displayed over ViewOptions::height_range

// Location of the drawn position; it differs from the position attribute on displaced meshes.
inline constexpr int drawn_location = attribute_count;

}  // namespace wrinkle::gpu
