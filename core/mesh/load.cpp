#include "mesh/load.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/diagnostics.h"
#include "base/file.h"
#include "mesh/readers.h"
#include "mesh/vertex_frames.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

constexpr float max_coordinate = 1e15F;  // squares of coordinates fit into float

void error(const fs::path& path, const std::string& message, const std::string& expected,
           Diagnostics& diagnostics) {
    diagnostics.add(
        file_problem(Severity::error, RuleId::mesh_unreadable, path.string(), message, expected));
}

template <typename T>
bool all_finite(const std::vector<T>& values) {
    for (const T& value : values)
        for (int k = 0; k < T::length(); ++k)
            if (!std::isfinite(value[k])) return false;
    return true;
}

// Returns "" if the mesh can be drawn, else the problem.
std::string problem_of(const Mesh& mesh) {
    if (!all_finite(mesh.positions)) return "a position is not a finite number";
    for (size_t set = 0; set < max_uv_sets; ++set)
        if (!all_finite(mesh.uvs[set]))
            return "a uv of set " + std::to_string(set) + " is not a finite number";
    if (!all_finite(mesh.colors)) return "a color is not a finite number";
    for (const glm::vec3 p : mesh.positions)
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > max_coordinate)
            return "a coordinate is beyond 1e15";
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        if (glm::length(glm::cross(b - a, c - a)) > 0) return "";
    }
    return mesh.indices.empty() ? "has no triangles" : "has no triangle with an area";
}

bool is_json(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != bytes.npos && bytes[first] == '{';
}

}  // namespace

std::optional<Mesh> load_mesh_bytes(std::string_view bytes, const fs::path& path,
                                    const MeshFileOptions& options, Diagnostics& diagnostics) {
    const bool gltf = bytes.starts_with("glTF") || is_json(bytes);
    if (!gltf && bytes.find('\0') != bytes.npos) {
        error(path, "is not a mesh file", "an OBJ, .gltf or .glb", diagnostics);
        return {};
    }
    auto mesh = gltf ? read_gltf(bytes, path, options, diagnostics)
                     : read_obj(bytes, path.string(), options.limits, diagnostics);
    if (!mesh) return {};
    const std::string problem = problem_of(*mesh);
    if (!problem.empty()) {
        error(path, problem, "a mesh with finite values and at least one face", diagnostics);
        return {};
    }
    complete_normals(*mesh);
    ensure_tangents(*mesh);
    return mesh;
}

std::optional<Mesh> load_mesh(const fs::path& path, const MeshFileOptions& options,
                              Diagnostics& diagnostics) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored) &&
        fs::file_size(path, ignored) > options.limits.max_bytes) {
        error(path, "is larger than " + std::to_string(options.limits.max_bytes) + " bytes",
              "split the file or simplify the mesh", diagnostics);
        return {};
    }
    std::string why;
    const auto bytes = read_file(path, options.limits.max_bytes, why);
    if (!bytes) {
        error(path, why, "an OBJ, .gltf or .glb file", diagnostics);
        return {};
    }
    return load_mesh_bytes(*bytes, path, options, diagnostics);
}

}  // namespace wrinkle
