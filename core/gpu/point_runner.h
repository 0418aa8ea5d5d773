// Runs GLSL once per point of a table and reads the results back as 32-bit floats: the way in which
// CPU and GPU are compared on equal inputs.
//
// Point i is one pixel of a float target. Its attributes come from float textures by texelFetch, so
// they arrive to the last bit, and stand as local variables of `body` under their names. The body
// assigns the vec4s out0, out1, …. Nothing is interpolated: texture() and dFdx have no meaning
// here, use textureLod, textureGrad and given differentials.
//
//   globals    text before main(): structs, uniforms, samplers, functions; no #version line
//   body       "WrinkleSurface_x s; s.normal = normal; out0 = vec4(wrinkle_x_normal(s), 1);"
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "gpu/material.h"
#include "image/mips.h"

namespace wrinkle::gpu {

struct PointAttribute {
    std::string name;
    int components = 1;         // 1 to 4: float, vec2, vec3, vec4
    std::vector<float> values;  // points * components
};

struct PointImage {
    std::string file;  // as a sampler names it
    const MipChain* chain = nullptr;
};

struct PointJob {
    std::string globals;
    std::string body;
    int outputs = 1;  // 1 to 8
    size_t points = 0;
    std::vector<PointAttribute> attributes;
    std::vector<MaterialSampler> samplers;  // files are looked up in `images` only
    std::vector<MaterialUniform> uniforms;
    std::vector<PointImage> images;
};

// result[output][point]
using PointResults = std::vector<std::vector<std::array<float, 4>>>;

// Errors: a table of the wrong size, an image that is not given, the driver's log (lines of the
// globals keep their numbers, those of the body begin at 200001). A context must be current.
std::optional<PointResults> run_points(const PointJob& job, Diagnostics& diagnostics);

}  // namespace wrinkle::gpu
