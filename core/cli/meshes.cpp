#include "cli/meshes.h"

#include <algorithm>

#include "base/mapped.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace wrinkle::cli {

std::vector<std::string> shape_names() {
    return mapped<std::string>(shapes(), &Shape::name);
}

std::string mesh_help() {
    return joined(shape_names(), ", ") + ", or an OBJ or glTF file";
}

bool is_mesh_path(const std::string& name_or_path) {
    return name_or_path.find_first_of("./") != name_or_path.npos;
}

std::string check_mesh(const std::string& name_or_path) {
    const auto names = shape_names();
    if (is_mesh_path(name_or_path) || std::ranges::find(names, name_or_path) != names.end())
        return "";
    return "'" + name_or_path + "' is none of " + mesh_help();
}

void declare_mesh(CLI::App& command, std::string& name_or_path, const std::string& doc) {
    command.add_option("--mesh", name_or_path, doc + mesh_help())
        ->type_name("NAME|PATH")
        ->check(check_mesh)
        ->capture_default_str();
}

std::optional<Mesh> open_mesh(const std::string& name_or_path, const CommonOptions& options,
                              Diagnostics& diagnostics, std::vector<std::string>* read,
                              bool* double_sided) {
    std::optional<Mesh> mesh = make_shape(name_or_path);
    MeshFileOptions file;
    file.root = options.root;
    std::vector<std::filesystem::path> external;
    file.read = &external;
    file.double_sided = double_sided;
    if (!mesh) {
        mesh = load_mesh(name_or_path, file, diagnostics);
        if (read) read->push_back(name_or_path);
    }
    for (const std::filesystem::path& path : external)
        if (read) read->push_back(path.string());
    if (mesh && options.no_tangents) mesh->tangents.clear();
    return mesh;
}

}  // namespace wrinkle::cli
