// Validates generated source with glslang, the reference compiler.
#pragma once

#include <map>
#include <span>
#include <string>

#include "emit/emit.h"

namespace wrinkle::test {

enum class Stage { vertex, fragment };

// "" if the source compiles by the rules of its #version (450: those of Vulkan), else glslang's log
// and the source with line numbers.
std::string compile_errors(const std::string& text, Stage stage);

// The same for HLSL, with glslang's HLSL front end.
std::string hlsl_errors(const std::string& text, Stage stage);

// True for GLSL and HLSL.
bool has_validator(const Target& target);

// The same for all sources of `shader`, for a target with a validator; function form is called by a
// small main().
std::string compile_errors(const Shader& shader);

// Location of a block, member or image as reported by glslang, by name.
struct Place {
    int binding = -1, offset = -1, size = -1;
};
std::map<std::string, Place> places(const std::string& text, Stage stage);

// A fragment shader of several materials in function form, of one target, that calls each of them.
std::string wrapped(std::span<const Shader> shaders);

}  // namespace wrinkle::test
