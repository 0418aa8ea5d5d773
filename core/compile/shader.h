// Compiles a project to a shader or loads its images, and reports each problem at its location. The
// program, the editor and the embedded library (core/api) share it: their output and messages are
// identical.
#pragma once

#include <string>

#include "glsl/emit.h"
#include "lower/material.h"

namespace wrinkle {

class TextureStore;
struct Document;

// Largest descriptor set and first binding that a caller may choose.
inline constexpr int max_descriptor_set = 31, max_first_binding = 4095;

// The default form of a target.
Form default_form(const Target& target);

// Returns a clause with the reason why target, form and differentials are incompatible; "" if they
// are compatible.
std::string form_conflict(const Target& target, Form form, Differentials differentials);

// Call before compiling for a mesh with a double-sided material (glTF): seen from behind, a bump is
// a dent. If the graph does not set "back_faces", sets the rule `flip` and reports a
// warning at `mesh`.
void follow_double_sided(Document& document, const std::string& mesh, Diagnostics& diagnostics);

// Compiles the project. If `diagnostics` already has errors, only checks the project, so that all
// problems are reported at once; the result is then not ok.
Compiled compile_or_check(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics);

// Reports the emitter's problems at the nodes that they name.
void report_emit(const Shader& shader, const Compiled& compiled, const Project& project,
                 Diagnostics& diagnostics);

// Reports images or outputs in excess of the limits that the target guarantees (cost/limits.h), as
// warnings that name them, or as errors if `strict`.
void check_limits(const Reflection& reflection, const std::string& file, bool strict,
                  Diagnostics& diagnostics);

struct ShaderOptions {
    MaterialOptions material;  // given_differentials is set from `emit`
    EmitOptions emit;          // without a form_conflict()
    bool strict = false;       // exceeding a guaranteed limit is an error
};

// Precondition of using the shader: `diagnostics` has no error.
struct MadeShader {
    Compiled compiled;
    Shader shader;
};
MadeShader make_shader(const Project& project, const Registry& registry, ShaderOptions options,
                       Diagnostics& diagnostics);

// Returns the reflection file of a shader: to_json() of the reflection with an additional last key
// "sha256": the hashes of the shader's sources, {"function": "..."} or {"vertex": "...",
// "fragment": "..."}. They show whether the files come from the same run.
std::string reflection_json(const Shader& shader);

// Reads the images that the module samples, for evaluation, baking and rendering. A problem is
// reported at the first node that reads the image; a file that fails is reported only once.
void read_textures(TextureStore& textures, const Compiled& compiled, const Project& project,
                   Diagnostics& diagnostics);

}  // namespace wrinkle
