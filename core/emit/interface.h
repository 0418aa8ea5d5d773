// Global part of a generated shader: global names, structs, uniforms, and their reflection.
#pragma once

#include "emit/body.h"
#include "emit/emit.h"

namespace wrinkle {

struct Interface {
    NameSet globals;
    Symbols symbols;
    Reflection reflection;
};

Interface make_interface(const EmitAnalysis& analysis, const EmitOptions& options);

// Returns an empty Text with the limit `most` in bytes and capacity reserved for the module.
Text reserve_text(const EmitAnalysis& analysis, uint64_t most);

// Append declarations to `text`.
void write_structs(const Language& language, const Reflection& reflection, Text& text);
void write_uniforms(const Module& module, const Language& language, const Reflection& reflection,
                    Text& text);
void write_precision(const Target& target, Text& text);  // before fragment code

// Sets the uses of numbers in the text, and the parameters and arguments that pass images and
// numbers to functions. Precondition: assign_bindings().
void set_resource_uses(const EmitAnalysis& analysis, const Language& language,
                       Interface& interface);

// Appends helper functions, then the material's.
void write_functions(const EmitAnalysis& analysis, const Interface& interface, const Target& target,
                     Text& text);

// Returns true if an output is of type normal.
bool has_normals(const Reflection& reflection);

// Returns the title comment: the graph's title, or NAME if it has none, and the conventions of the
// text where they differ from the defaults.
std::string title_of(const Module& module, const Reflection& reflection);

// Writes the complete vertex and fragment pair; adds attributes, varyings and frame uniforms to the
// reflection.
void write_shader_form(const EmitAnalysis& analysis, const EmitOptions& options,
                       Interface& interface, Shader& shader);

}  // namespace wrinkle
