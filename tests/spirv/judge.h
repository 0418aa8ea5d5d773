// Validates the output of each target: GLSL by glslang with the target's rules, SPIR-V by
// spirv-val, HLSL by glslang's HLSL front end, Metal by the reflection, the brackets of the others,
// for which Debian has no compiler (tests/godot and tests/webgl have those of `./run test --all`).
#pragma once

#include <string>

#include "emit/emit.h"

namespace wrinkle::test {

std::string errors_of(const Shader& shader);  // "" if there are none

}  // namespace wrinkle::test
