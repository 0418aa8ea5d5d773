// What stands outside the functions: the names of everything global, the struct, the uniforms, and
// the reflection that says so.
#pragma once

#include "glsl/body.h"
#include "glsl/emit.h"

namespace wrinkle {

struct Interface {
    NameSet globals;
    Symbols symbols;
    Reflection reflection;
};

Interface make_interface(const Plan& plan, const EmitOptions& options);

// A text with room for all that is written of the module, of at most so many bytes.
Text roomy_text(const Plan& plan, uint64_t most);

// What is appended to it.
void write_struct(const Reflection& reflection, Text& text);
void write_uniforms(const Module& module, const Reflection& reflection, Text& text);
void write_precision(const Target& target, Text& text);  // before fragment code

// "WrinkleSurface_NAME s", or "" where there is no struct.
std::string argument_text(const Reflection& reflection);

// Appends helper functions, then one per output.
void write_functions(const Plan& plan, const Interface& interface, const Target& target,
                     Text& text);

// The first line: the graph's name, or NAME.
std::string title_of(const Module& module, const std::string& name);

// The complete vertex and fragment pair; adds attributes, varyings and frame uniforms.
void write_shader_form(const Plan& plan, const EmitOptions& options, Interface& interface,
                       Shader& shader);

}  // namespace wrinkle
