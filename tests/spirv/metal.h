// Validates Metal source against the reflection, because Debian has no compiler for it.
#pragma once

#include <string>

#include "emit/emit.h"

namespace wrinkle::test {

// "" if the brackets outside of comments are balanced, else the error.
std::string bracket_errors(const std::string& text);

// "" if both stages of a pair have their entry points, every block, image, attribute and output has
// its number exactly once, and brackets are balanced; else the error.
std::string metal_errors(const Shader& shader);

}  // namespace wrinkle::test
