// Emits readable GLSL from an expanded module (ir/expand.h: no opaque ops, no ddx or ddy): one
// function that computes all outputs, or a complete vertex and fragment pair. The output is
// deterministic: equal modules give equal bytes in any order of creation of their instructions.
// Linear time, constant stack.
//
// function   WrinkleMaterial_NAME wrinkle_NAME(WrinkleSurface_NAME s), to include in an engine's
//            shader. The result has a member per output. Unused members, uniforms and helper
//            functions are not emitted; the argument is omitted if no output depends on it.
//            Every global name contains NAME, so materials of several names share one shader.
//            Inputs are in object space, results in `normal_space`.
// shader     Attributes position, normal, tangent, uv0 ... color0 (locations in emit/attributes.h).
//            Uniforms, where used:
//              wrinkle_object_to_clip   mat4, into the clip space of the target's own API
//              wrinkle_object_to_world  mat4 M, for outputs of type normal, which are unit vectors
//                                       in world space: normalize(cof(M) n) times sign of det(M)
//              wrinkle_eye              vec3, the eye in object space
//            One fragment output out_NAME per graph output, with the output's type, at locations 0,
//            1, ... without gaps: first those of base/standard_outputs.h in its order, then
//            others in graph order. Drivers support at least 8 draw buffers, ES drivers 4.
//            gl_FrontFacing must be true if the surface is seen from the side its normal points to:
//            flip glFrontFace for a mirrored matrix.
//
// Differentials: `screen` takes dFdx and dFdy of the struct's members. `given` expects additional
// members uv0_dx, uv0_dy, ..., and a module in which samples have an explicit lod (explicit_lod()
// in ir/rewrite.h). `none` expects a module without_differentials(), as for a vertex stage. The
// shader form accepts only `screen`. UvOrigin::top expects a module with_uv_origin_top(),
// NormalSpace::tangent a module with_tangent_space_normals().
//
// If a target numbers its resources, the uniforms of the shader form are in the block WrinkleFrame,
// the others in WrinkleParameters_NAME. Blocks, then images, are numbered from `first_binding` on
// in the set `set`; if the target numbers each kind separately, images also begin at
// `first_binding`. For a target that is not GLSL, the sources are the GLSL 4.50 that core/spirv
// translates.
//
// A `parameter` that remains in the module becomes a uniform NAME_NODE_PORT; that of a graph input
// NAME_input_INPUT. The sampler of an image is NAME_NODE_PORT of its first reader.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/limits.h"
#include "emit/reflection.h"
#include "emit/target.h"
#include "ir/side_tables.h"

namespace wrinkle {

enum class Differentials : uint8_t { screen, given, none };

struct EmitOptions {
    Form form = Form::function;
    Differentials differentials = Differentials::screen;
    std::string name = "material";  // NAME; converted to an identifier
    const Target* target = &targets().front();
    UvOrigin uv_origin = UvOrigin::bottom;
    NormalSpace normal_space = NormalSpace::object;  // function form
    int set = 0, first_binding = 0;
    bool bare_result = false;  // return the value of the only output, not a struct with it
    uint64_t max_bytes = limit_of(Limit::text_bytes);  // size of a stage; if exceeded, a problem
};

struct Shader {
    std::string source;    // function form
    std::string vertex;    // shader form
    std::string fragment;  // shader form
    Reflection reflection;
    std::vector<Problem> problems;  // if not empty, the sources are empty
    bool over_limit = false;        // EmitOptions::max_bytes was exceeded
};

// NAME for a graph's file: its stem as an identifier; "stdin" for "-".
std::string material_name(const std::filesystem::path& file);

Shader emit(const Module& module, const EmitOptions& options);

}  // namespace wrinkle
