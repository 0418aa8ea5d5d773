// The reflection that is written beside a shader's texts.
#pragma once

#include <string>

#include "glsl/emit.h"

namespace wrinkle {

// to_json() of the reflection with one more key at its end: "sha256", the sums of the texts it is
// of, {"function": "..."} or {"vertex": "...", "fragment": "..."}. A reader sees by it whether the
// files it has are of one run.
std::string reflection_json(const Shader& shader);

}  // namespace wrinkle
