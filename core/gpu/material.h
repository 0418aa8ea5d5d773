// A material as input of the renderer: the GLSL source of the `function` form, which computes
// differentials by dFdx and dFdy, and its interface. Plain data, filled by material_from().
//
// `text` declares a struct, uniforms, samplers, and one function per output that takes the struct.
// The renderer generates a vertex and a fragment shader around the source, fills the struct's
// members by their surface property, calls the functions in uniform control flow and transforms the
// object-space normal to world space.
//
// Properties, all in object space (in brackets the type that the renderer provides):
//   position [vec3]            the surface point
//   position_relative [vec3]   position minus the eye, in object axes
//   normal [vec3]              interpolated, not normalised; not flipped towards the eye
//   tangent [vec4]             interpolated, not normalised; w = sign
//   uv0 … uv3 [vec2]  color0 [vec4]
//   view [vec3]                unit, towards the eye
//   facing [float]             +1 if seen from the side the normal points to, else -1
#pragma once

#include <string>
#include <vector>

#include "base/texture_options.h"

namespace wrinkle {
struct Shader;
}

namespace wrinkle::gpu {

struct Member {
    std::string name;      // struct member
    std::string type;      // GLSL
    std::string property;  // one of the properties above

    friend bool operator==(const Member&, const Member&) = default;
};

struct OutputFunction {
    std::string output;    // "normal", "color", "roughness", …
    std::string function;  // name in the source
    std::string type;      // GLSL return type

    friend bool operator==(const OutputFunction&, const OutputFunction&) = default;
};

struct MaterialSampler {
    std::string name;        // name in the source, a sampler2D
    std::string file;        // the image file; also the renderer's key for the texture
    TextureOptions options;  // wrap and filter; the source decodes the encoding
};

struct MaterialUniform {
    std::string name;
    std::vector<float> value;  // 1 to 4 components
};

struct Material {
    std::string text;
    std::vector<std::string> nodes;  // node of each source line, "" if it has none
    std::string struct_name;         // "" if the functions take no argument
    std::vector<Member> members;     // in the order of the struct
    std::vector<OutputFunction> outputs;
    std::vector<MaterialSampler> samplers;
    std::vector<MaterialUniform> uniforms;
};

// Converts a generated shader and its reflection. Uniforms get the values of the graph; samplers
// get the file name under which the image is opened. Precondition: the shader has no problems, is
// in the function form and has differentials from the screen.
Material material_from(const Shader& shader);

const OutputFunction* find_output(const Material& material, const std::string& output);

}  // namespace wrinkle::gpu
