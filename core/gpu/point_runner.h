// Runs GLSL once per point of a table and reads the results back as 32-bit floats, to compare CPU
// and GPU on equal inputs.
//
// Point i is one pixel of a float target. Its attributes are fetched bit-exactly from float
// textures by texelFetch and are local variables of `body` with the attributes' names. The body
// assigns the vec4s out0, out1, …. Nothing is interpolated, so texture() and dFdx are meaningless
// here: use textureLod, textureGrad and given differentials.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "emit/reflection.h"
#include "image/mips.h"

namespace wrinkle {
struct Shader;
}

namespace wrinkle::gpu {

struct PointAttribute {
    std::string name;
    int components = 1;         // 1 to 4: float, vec2, vec3, vec4
    std::vector<float> values;  // points * components
};

struct PointImage {
    std::string file;  // SamplerInfo::file
    const MipChain* chain = nullptr;
};

struct PointJob {
    // Source before main(): structs, uniforms, samplers, functions; no #version line.
    std::string globals;
    // "WrinkleSurface_x s; s.normal = normal; out0 = vec4(wrinkle_x_normal(s), 1);"
    std::string body;
    int outputs = 1;  // at least 1
    size_t points = 0;
    std::vector<PointAttribute> attributes;
    std::vector<SamplerInfo> samplers;  // files are searched only in `images`
    std::vector<UniformInfo> uniforms;
    std::vector<PointImage> images;
};

// Precondition: the shader has no problems, is in the function form and has given differentials.
// Output k of the job is function k, its value in the first components. The caller adds the points,
// the images, and for each member of the struct an attribute with the member's name.
PointJob point_job_from(const Shader& shader);

// result[output][point]
using PointResults = std::vector<std::vector<std::array<float, 4>>>;

// Precondition: a context is current. Returns std::nullopt and reports an error for a table of the
// wrong size, an image missing from `images`, or a shader that the driver rejects. The line numbers
// in the driver's log count from 1 in `globals` and from 200001 in `body`.
std::optional<PointResults> run_points(const PointJob& job, Diagnostics& diagnostics);

}  // namespace wrinkle::gpu
