#include "mesh/mesh.h"

#include <glm/common.hpp>

namespace wrinkle {

Bounds bounds_of(const Mesh& mesh) {
    if (mesh.indices.empty()) return {};
    const std::vector<glm::vec3>& positions = mesh.drawn();
    const glm::vec3 first = positions[mesh.indices.front()];
    Bounds bounds{first, first};
    for (uint32_t index : mesh.indices) {
        bounds.low = glm::min(bounds.low, positions[index]);
        bounds.high = glm::max(bounds.high, positions[index]);
    }
    return bounds;
}

namespace {

template <typename T>
void append_copy(std::vector<T>& values, uint32_t index) {
    if (values.empty()) return;
    const T value = values[index];
    values.push_back(value);
}

}  // namespace

uint32_t copy_vertex(Mesh& mesh, uint32_t index) {
    append_copy(mesh.positions, index);
    append_copy(mesh.normals, index);
    append_copy(mesh.tangents, index);
    for (auto& uv : mesh.uvs)
        append_copy(uv, index);
    append_copy(mesh.colors, index);
    append_copy(mesh.displaced, index);
    return static_cast<uint32_t>(mesh.vertex_count() - 1);
}

}  // namespace wrinkle
