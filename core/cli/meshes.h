// Mesh arguments of commands: the name of a shape, or the path of a file.
//
// A text without '.' and '/' is a name. External files of a glTF must be below the mesh's folder or
// below --root.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/session.h"
#include "mesh/mesh.h"

namespace wrinkle::cli {

std::vector<std::string> shape_names();

std::string mesh_help();  // "sphere, plane, ..., or an OBJ or glTF file"

bool is_mesh_path(const std::string& name_or_path);

// Returns an error message for an unknown shape name, otherwise "".
std::string check_mesh(const std::string& name_or_path);

// Adds --mesh; its initial value is the default. The list of shapes is appended to `doc`.
void declare_mesh(CLI::App& command, std::string& name_or_path, const std::string& doc);

// Returns the mesh, without tangents if --no-tangents is set; std::nullopt and errors that name the
// file on failure. Appends the paths of all read files to `read`. For a glTF, sets `double_sided`
// to true if one of its materials is double-sided, otherwise to false.
std::optional<Mesh> open_mesh(const std::string& name_or_path, const CommonOptions& options,
                              Diagnostics& diagnostics, std::vector<std::string>* read = nullptr,
                              bool* double_sided = nullptr);

}  // namespace wrinkle::cli
