// A material as the renderer takes it: the text of the `function` form with differentials from the
// screen, and what must be known to call it. Plain data, filled from the reflection of core/glsl.
//
// `text` declares a struct, its uniforms and samplers, and one function per output that takes the
// struct. The renderer is an engine like any other: it writes its own vertex and fragment shader
// round the text, fills the struct's members by their surface property, calls the functions in
// uniform control flow and brings the object-space normal to the world.
//
// Properties, all in object space (types in brackets are what the renderer gives):
//   position [vec3]            the surface point
//   position_relative [vec3]   the same seen from the eye, in object axes
//   normal [vec3]              interpolated, not normalised; never turned towards the eye
//   tangent [vec4]             interpolated, not normalised; w = sign
//   uv0 … uv3 [vec2]  color0 [vec4]
//   view [vec3]                unit, towards the eye
//   facing [float]             +1 seen from the side the normal points to, else -1
#pragma once

#include <string>
#include <vector>

#include "base/texture_options.h"

namespace wrinkle::gpu {

struct Member {
    std::string name;      // in the struct
    std::string type;      // GLSL
    std::string property;  // one of those above

    friend bool operator==(const Member&, const Member&) = default;
};

struct OutputFunction {
    std::string output;    // "normal", "color", "roughness", …
    std::string function;  // its name in the text
    std::string type;      // what it returns, GLSL

    friend bool operator==(const OutputFunction&, const OutputFunction&) = default;
};

struct MaterialSampler {
    std::string name;        // of the sampler2D in the text
    std::string file;        // the image, and the name under which the renderer keeps it
    TextureOptions options;  // wrap and filter; the encoding is arithmetic in the text
};

struct MaterialUniform {
    std::string name;
    std::vector<float> value;  // 1 to 4 components
};

struct Material {
    std::string text;
    std::vector<std::string> nodes;  // by line of the text the node it came from, "" for none
    std::string struct_name;         // "" when the functions take no argument
    std::vector<Member> members;     // in the order of the struct
    std::vector<OutputFunction> outputs;
    std::vector<MaterialSampler> samplers;
    std::vector<MaterialUniform> uniforms;
};

const OutputFunction* find_output(const Material& material, const std::string& output);

}  // namespace wrinkle::gpu
