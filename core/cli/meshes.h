// Meshes as commands take them: the name of a shape, or the path of a file.
//
// A text without '.' and '/' is a name. External files of a glTF may lie below the mesh's own
// folder and below --root.
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

// For CLI11: refuses a name that no shape has; "" for what is fine.
std::string check_mesh(const std::string& name_or_path);

// The mesh, without tangents for --no-tangents; nothing with errors that name the file. `read`
// takes the paths of all files that it is made of, `double_sided` whether a material of a glTF is.
std::optional<Mesh> open_mesh(const std::string& name_or_path, const CommonOptions& options,
                              Diagnostics& diagnostics, std::vector<std::string>* read = nullptr,
                              bool* double_sided = nullptr);

}  // namespace wrinkle::cli
