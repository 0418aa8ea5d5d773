// A project's shader with every problem said at its place: what `wrinkle compile` and the embedded
// library (core/api) write, byte for byte and word for word.
#pragma once

#include <string>

#include "glsl/emit.h"
#include "lower/material.h"

namespace wrinkle {

// What the numbers of a caller's resources may be.
inline constexpr int max_descriptor_set = 31, max_first_binding = 4095;

// The form that a target is written in where nobody says which.
Form default_form(const Target& target);

// Why a target, a form and differentials do not go together, a clause; "" when they do.
std::string form_conflict(const Target& target, Form form, Differentials differentials);

// Compiles. Where the project has errors already the rest of it is checked as well, so that every
// problem is reported in one go.
Compiled compile_or_check(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics);

// Problems of the emitter, at the nodes they name.
void report_emit(const Shader& shader, const Compiled& compiled, const Project& project,
                 Diagnostics& diagnostics);

// More images or outputs than every machine of the target has room for: warnings that name them,
// with `strict` errors.
void judge_limits(const Reflection& reflection, const std::string& file, bool strict,
                  Diagnostics& diagnostics);

struct ShaderOptions {
    MaterialOptions material;  // given differentials follow `emit`
    EmitOptions emit;          // without a conflict
    bool strict = false;       // what not every machine has is an error
};

// What the shader is good for only as long as `diagnostics` has no error.
struct MadeShader {
    Compiled compiled;
    Shader shader;
};
MadeShader make_shader(const Project& project, const Registry& registry, ShaderOptions options,
                       Diagnostics& diagnostics);

}  // namespace wrinkle
