// Code around a material's function in a host's shader.
#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "emit/language.h"
#include "emit/reflection.h"

namespace wrinkle {

// Returns the template with each field @NAME@ replaced by its text.
std::string with_fields(std::string_view text,
                        std::initializer_list<std::pair<std::string_view, std::string>> fields);

// Returns the text with each line indented further, without empty lines.
std::string indented(std::string_view text, size_t spaces);

// Returns "s.uv0 = INPUT;" for each member of the surface, a line each, indented by four spaces;
// `inputs` has the expression of every member of the reflection by its name.
std::string surface_assignments(const Reflection& reflection,
                                const std::map<std::string_view, std::string_view>& inputs);

// Returns the expression of a standard output in the variable `result`; where the graph does not
// have it, its default (base/standard_outputs.h) as a literal, which must be a number or a color.
std::string output_expression(const Reflection& reflection, const Language& language,
                              std::string_view output, std::string_view result = "m");
bool has_output(const Reflection& reflection, std::string_view output);

// Returns a block of statements that apply a coat to `color`, a variable, as host_base_color()
// does; `value` gives the expression of an output. Valid in GLSL, HLSL and Godot's language.
std::string coat_text(const Language& language, const std::string& color,
                      const std::function<std::string(std::string_view)>& value);

}  // namespace wrinkle
