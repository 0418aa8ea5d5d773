// Parts of an export to Godot: the text of a spatial shader, textures, and a scene.
//
// Godot 3 and 4 differ in names, formats and languages; GodotVersion holds the differences that are
// words. Both have right-handed axes with y up, uv origin top left, clockwise front faces, and take
// normals in view space (Godot's documentation, "Spatial shaders").
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emit/emit.h"
#include "export/export.h"

namespace wrinkle {

struct GodotVersion {
    int major;
    std::string_view label;                                          // "Godot 3"
    std::string_view target;                                         // emit/target.h
    std::string_view extension;                                      // that shaders have
    std::string_view object_to_world, world_to_view, view_to_world;  // built-in matrices
    std::string_view alpha_mode;  // render mode: opaque texels write depth
};
const GodotVersion& godot_version(int major);  // 3 or 4

// Functions of a graph for Godot: the material and its displacement, if it has one. Samplers and
// inputs that both read have one name.
struct GodotShader {
    Shader fragment;
    std::optional<Shader> vertex;
    std::vector<SamplerInfo> samplers;
    std::vector<UniformInfo> inputs;  // exposed inputs
};

// Appends a warning for each output of the graph without a counterpart. Returns std::nullopt and
// appends errors on failure, for example for a graph that reads a uv set which Godot does not have.
std::optional<GodotShader> compile_for_godot(const ExportRequest& request,
                                             const GodotVersion& version, Diagnostics& diagnostics);

struct GodotTexture {
    std::string sampler;  // SamplerInfo::name
    std::string file;     // below the material's folder
    std::string hints;    // for the sampler: "hint_albedo", "source_color, repeat_enable"; or ""
};

// Writes the images that the samplers read. Godot 3: .stex, Godot's own format, with Wrinkle's mips
// and without loss: its importer cuts 16 bits and floats to half precision. Godot 4: PNG and EXR,
// each with an .import file. Returns std::nullopt and appends an error on failure.
std::optional<std::vector<GodotTexture>> write_godot_textures(
    const ExportRequest& request, const GodotVersion& version,
    const std::vector<SamplerInfo>& samplers, const std::filesystem::path& folder,
    Diagnostics& diagnostics);

// A shader parameter: its name, its declaration in the shader and its value in a .tres file.
struct GodotParameter {
    std::string name, declaration, value;
    std::string expression;  // in the function's text; "": the name
};
std::vector<GodotParameter> godot_parameters(const ExportRequest& request,
                                             const GodotVersion& version,
                                             const GodotShader& shader);

// Returns a spatial shader.
std::string godot_shader_text(const ExportRequest& request, const GodotVersion& version,
                              const GodotShader& shader,
                              const std::vector<GodotParameter>& parameters,
                              const std::vector<GodotTexture>& textures);

// Returns the statements of fragment() that assign Godot's outputs; `values` holds the expressions
// of the graph's outputs by name.
std::string godot_assignments(const GodotVersion& version,
                              const std::map<std::string, std::string>& values,
                              const std::string& to_view);
bool godot_takes(std::string_view output);  // godot_assignments() reads it

// Writes a project with a main scene that shows `material`, a path below `folder`, on the mesh.
bool write_godot_project(const ExportRequest& request, const GodotVersion& version,
                         const std::string& material, const std::filesystem::path& folder,
                         Diagnostics& diagnostics);

}  // namespace wrinkle
