// One graph compiled, as the commands that need its text or its numbers ask for it.
#pragma once

#include "cli/session.h"
#include "glsl/emit.h"
#include "lower/material.h"

namespace wrinkle::cli {

// The graph's name in generated text: its file's stem as an identifier.
std::string material_name(const std::string& file);

// Compiles. Where the project has errors already the rest of it is checked as well, so that every
// problem is reported in one go.
Compiled compile_or_check(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics);

// A problem of the emitter, at the node it names.
void report_emit(const Shader& shader, const Compiled& compiled, const Project& project,
                 Diagnostics& diagnostics);

}  // namespace wrinkle::cli
