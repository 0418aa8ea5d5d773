// Generated texts through glslang, the reference compiler.
#pragma once

#include <map>
#include <string>

#include "glsl/emit.h"

namespace wrinkle::test {

enum class Stage { vertex, fragment };

// "" when the text compiles by the rules that its #version names (450: those of Vulkan), else
// glslang's log and the text with line numbers.
std::string compile_errors(const std::string& text, Stage stage);

// The same of HLSL, by glslang's front end for it.
std::string hlsl_errors(const std::string& text, Stage stage);

// The same of everything that `shader` holds, whose target is a GLSL; function form is called by a
// small main().
std::string compile_errors(const Shader& shader);

// Where glslang finds the blocks, their members and the images of a text, by name.
struct Place {
    int binding = -1, offset = -1, size = -1;
};
std::map<std::string, Place> places(const std::string& text, Stage stage);

// The small fragment shader round a text of the function form.
std::string wrapped(const Shader& shader);

}  // namespace wrinkle::test
