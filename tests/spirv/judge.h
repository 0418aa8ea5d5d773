// Whether what is written for a target is right in its language: GLSL is judged by glslang by the
// rules of each target, SPIR-V by spirv-val, HLSL by glslang's front end for it, Metal by what the
// reflection says.
#pragma once

#include <string>

#include "glsl/emit.h"

namespace wrinkle::test {

std::string errors_of(const Shader& shader);  // "" of none

}  // namespace wrinkle::test
