// Any bytes as a mesh file: nothing crashes; the answer is a mesh with finite values, unit frames
// and indices in range, or errors that name the file.
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "mesh/load.h"
#include "mesh/sample.h"

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

template <typename T>
void require_finite(const std::vector<T>& values, size_t count, bool needed) {
    require(values.size() == count || (!needed && values.empty()));
    for (const T& value : values)
        for (int k = 0; k < T::length(); ++k)
            require(std::isfinite(value[k]));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    using namespace wrinkle;
    Diagnostics diagnostics;
    MeshFileOptions options;
    options.limits.max_corners = 1 << 16;
    options.limits.max_bytes = 1 << 20;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto mesh = load_mesh_bytes(bytes, "nowhere/fuzz.mesh", options, diagnostics);
    require(mesh.has_value() != diagnostics.has_errors());
    for (const Diagnostic& diagnostic : diagnostics.list())
        require(diagnostic.where.file == "nowhere/fuzz.mesh" && !diagnostic.message.empty());
    if (!mesh) return 0;
    const size_t count = mesh->vertex_count();
    require(mesh->triangle_count() > 0 && mesh->indices.size() % 3 == 0);
    for (const uint32_t index : mesh->indices)
        require(index < count);
    require_finite(mesh->positions, count, true);
    require_finite(mesh->normals, count, true);
    require_finite(mesh->tangents, count, mesh->has_uv(0));
    require_finite(mesh->colors, count, false);
    for (const auto& uvs : mesh->uvs)
        require_finite(uvs, count, false);
    for (const glm::vec3 normal : mesh->normals)
        require(std::abs(glm::length(normal) - 1) < 1e-3F);
    for (const glm::vec4& tangent : mesh->tangents)
        require(std::abs(tangent.w) == 1 && glm::length(glm::vec3(tangent)) > 0.4F);
    Diagnostics ignored;
    sample_mesh(*mesh, {0.5, 0.5}, 1024, ignored);
    return 0;
}
