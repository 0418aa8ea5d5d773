// GLSL text for people: an expanded module (ir/expand.h: no opaque ops, no ddx or ddy) as one
// function per output, or as a complete vertex and fragment pair. Equal modules give equal bytes
// whatever the order their instructions were made in. Linear time, constant stack.
//
// function   wrinkle_NAME_OUTPUT(WrinkleSurface_NAME s), for an engine's own shader. The struct,
//            uniforms and helper functions hold only what is used; there is no struct and no
//            argument when no output depends on the surface. Object space in, object space out.
// shader     Attributes position, normal, tangent, uv0 ... color0 (locations in glsl/attributes.h).
//            Uniforms, where used:
//              wrinkle_object_to_clip   mat4, into the clip space of the target's own API
//              wrinkle_object_to_world  mat4, for outputs of type normal, which leave as unit
//                                       vectors of the world: cof(M) times the sign of det(M)
//              wrinkle_eye              vec3, the eye in object space
//            One fragment output out_NAME per graph output, of its own type, at the locations 0, 1,
//            ... without gaps: normal, color, roughness, metalness, occlusion, height and
//            displacement, those that the graph has, then others in graph order. Drivers draw to 8
//            at least, those of ES to 4. gl_FrontFacing must be true where the surface is seen from
//            the side its normal points to: turn glFrontFace for a mirrored matrix.
//
// Differentials: screen takes dFdx and dFdy of the struct's members; given expects members uv0_dx,
// uv0_dy, ... beside them, and a module in which samples have an explicit lod (explicit_lod() in
// ir/rewrite.h). The shader form with given differentials is refused: there is nobody to give them.
//
// A target that numbers its resources has the shader form's own uniforms in the block WrinkleFrame,
// the others in WrinkleParameters_NAME. Blocks and then images are numbered from `first_binding` on
// in the set `set`; where kinds are numbered for themselves, images begin at `first_binding` too.
// The texts of a target that is no GLSL are the GLSL 4.50 that core/spirv translates.
//
// A `parameter` that remains in the module is a uniform NODE_PORT, of a graph input input_NAME.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/limits.h"
#include "glsl/reflection.h"
#include "glsl/target.h"
#include "ir/module.h"

namespace wrinkle {

enum class Form : uint8_t { function, shader };
enum class Differentials : uint8_t { screen, given };

struct EmitOptions {
    Form form = Form::function;
    Differentials differentials = Differentials::screen;
    std::string name = "material";  // NAME; made an identifier where it is none
    const Target* target = &targets().front();
    int set = 0, first_binding = 0;
    uint64_t max_bytes = limit_of(Limit::text_bytes);  // of a stage's text; beyond is a problem
};

struct Shader {
    std::string source;    // function form
    std::string vertex;    // shader form
    std::string fragment;  // shader form
    Reflection reflection;
    std::vector<Problem> problems;  // the texts are empty when there are any
    bool over_limit = false;        // one of them is of EmitOptions::max_bytes
};

// NAME of a graph's file: its stem; "stdin" of "-".
std::string material_name(const std::filesystem::path& file);

Shader emit(const Module& module, const EmitOptions& options);

}  // namespace wrinkle
