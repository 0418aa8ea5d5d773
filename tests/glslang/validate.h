// Generated texts through glslang, the reference compiler.
#pragma once

#include <string>

#include "glsl/emit.h"

namespace wrinkle::test {

enum class Stage { vertex, fragment };

// "" when the text compiles, else glslang's log and the text with line numbers.
std::string compile_errors(const std::string& text, Stage stage);

// The same of everything that `shader` holds; function form is called by a small main().
std::string compile_errors(const Shader& shader);

// The small fragment shader round a text of the function form.
std::string wrapped(const Shader& shader);

}  // namespace wrinkle::test
