// Compiles a project to a material module or a shader, and loads its images. The program, the
// editor and the embedded library (core/api) share these functions, so that their output and
// messages are identical.
#pragma once

#include <optional>
#include <string>

#include "emit/emit.h"
#include "lower/material.h"

namespace wrinkle {

class TextureStore;
struct Document;

// Largest descriptor set and first binding that a caller may choose.
inline constexpr int max_descriptor_set = 31, max_first_binding = 4095;

// Returns the reason, as a clause, if target, form, differentials and a chosen space of normals are
// incompatible; else "".
std::string form_conflict(const Target& target, Form form, Differentials differentials,
                          std::optional<NormalSpace> normal_space);

// Applies glTF's `doubleSided`, which flips the normals of back faces: if the graph does not set
// "back_faces", sets BackFaces::flip and reports a warning at the file `mesh`. Call before
// compiling for a mesh with a double-sided material.
void follow_double_sided(Document& document, const std::string& mesh, Diagnostics& diagnostics);

// Compiles the project. If `diagnostics` has errors already, for example from reading, only checks
// the project, so that all problems are reported in one run; the result is then not ok.
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
    EmitOptions emit;          // without a form_conflict(); bare_result is set from `outputs`
    std::vector<std::string> outputs;  // empty: all; one: the function returns a bare value
    bool strict = false;               // exceeding a guaranteed limit is an error
};

struct MadeShader {
    Compiled compiled;
    Shader shader;
};
// Compiles the project, emits the shader and checks its limits. Use the result only if
// `diagnostics` has no error.
MadeShader make_shader(const Project& project, const Registry& registry, ShaderOptions options,
                       Diagnostics& diagnostics);

// Returns the reflection as JSON with the inputs of the graph as "inputs" (lower/exposed.h), and
// the hashes of the sources as the last key, "sha256": {"function": "..."} or {"vertex": "...",
// "fragment": "..."}. With them, a program detects source and reflection files of different runs.
// The shader must be that of the project.
std::string reflection_json(const Shader& shader, const Project& project, const Registry& registry);

// Loads the images that the module samples, for evaluation, baking and rendering. Reports a problem
// at the first port that reads the image; `textures` reports each file only once.
void read_textures(TextureStore& textures, const Compiled& compiled, const Project& project,
                   Diagnostics& diagnostics);

}  // namespace wrinkle
