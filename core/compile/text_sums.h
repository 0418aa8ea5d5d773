// The reflection file that is written next to a shader's source files.
#pragma once

#include <string>

#include "glsl/emit.h"

namespace wrinkle {

// Returns to_json() of the reflection with an additional last key "sha256": the hashes of the
// shader's sources, {"function": "..."} or {"vertex": "...", "fragment": "..."}. They show whether
// the files come from the same run.
std::string reflection_json(const Shader& shader);

}  // namespace wrinkle
