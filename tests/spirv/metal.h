// Metal, for which Debian has no compiler: its texts against what the reflection says of them.
#pragma once

#include <string>

#include "glsl/emit.h"

namespace wrinkle::test {

// "" when both stages have their entry points, every block, image, attribute and output stands at
// its number exactly once, and brackets are balanced; else what is wrong.
std::string metal_errors(const Shader& shader);

}  // namespace wrinkle::test
