// Fuzz target: the result is a mesh with finite values, unit frames and indices in range, or errors
// that name the file.
#include <cmath>
#include <glm/geometric.hpp>

#include "fuzz/fuzz.h"
#include "mesh/load.h"
#include "support/surface.h"

namespace wrinkle::fuzz {
namespace {

template <typename T>
bool finite(const std::vector<T>& values, size_t count, bool needed) {
    if (values.empty() && !needed) return true;
    if (values.size() != count) return false;
    for (const T& value : values)
        for (int k = 0; k < T::length(); ++k)
            if (!std::isfinite(value[k])) return false;
    return true;
}

std::string wrong_with(const Mesh& mesh) {
    const size_t count = mesh.vertex_count();
    if (mesh.triangle_count() == 0 || mesh.indices.size() % 3 != 0) return "no whole triangles";
    for (const uint32_t index : mesh.indices)
        if (index >= count) return "an index out of range";
    bool fine = finite(mesh.positions, count, true) && finite(mesh.normals, count, true) &&
                finite(mesh.tangents, count, mesh.has_uv(0)) && finite(mesh.colors, count, false);
    for (const auto& uvs : mesh.uvs)
        fine = fine && finite(uvs, count, false);
    if (!fine) return "an attribute of another length, or no finite number";
    for (const glm::vec3 normal : mesh.normals)
        if (std::abs(glm::length(normal) - 1) >= 1e-3F) return "a normal that is not of length 1";
    for (const glm::vec4& tangent : mesh.tangents)
        if (std::abs(tangent.w) != 1 || glm::length(glm::vec3(tangent)) <= 0.4F)
            return "a short tangent, or one without a sign";
    return "";
}

}  // namespace

std::string mesh(std::string_view bytes) {
    Diagnostics diagnostics;
    MeshFileOptions options;
    options.limits.max_corners = 1 << 16;
    options.limits.max_bytes = 1 << 20;
    const auto mesh = load_mesh_bytes(bytes, "nowhere/fuzz.mesh", options, diagnostics);
    if (mesh.has_value() == diagnostics.has_errors()) return "a mesh and an error, or neither";
    for (const Diagnostic& diagnostic : diagnostics.list())
        if (diagnostic.where.file != "nowhere/fuzz.mesh" || diagnostic.message.empty())
            return "a problem without its file or its words";
    if (!mesh) return "";
    if (mesh->has_uv(0)) test::sample_surface(*mesh, {0.5, 0.5}, 1024);
    return wrong_with(*mesh);
}

}  // namespace wrinkle::fuzz
