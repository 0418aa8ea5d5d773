#include "mesh/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "mesh/vertex_frames.h"
#include "mesh/weld.h"

namespace wrinkle {
namespace {

template <typename T>
void append_values(std::vector<T>& all, const std::vector<T>& values, size_t before, size_t count,
                   T missing) {
    if (all.empty() && values.empty()) return;
    all.resize(before, missing);
    all.insert(all.end(), values.begin(), values.end());
    all.resize(before + count, missing);
}

}  // namespace

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

void transform(Mesh& mesh, const glm::dmat4& m) {
    if (m == glm::dmat4(1)) return;
    const glm::dmat3 linear(m);
    const double sign = glm::determinant(linear) < 0 ? -1 : 1;
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    for (glm::vec3& position : mesh.positions)
        position = glm::dvec3(m * glm::dvec4(position, 1));
    for (glm::vec3& normal : mesh.normals) {
        const glm::dvec3 moved = unit_or_zero(sign * (cofactors * glm::dvec3(normal)));
        if (moved != glm::dvec3(0)) normal = moved;
    }
    for (glm::vec4& tangent : mesh.tangents) {
        const glm::dvec3 moved = unit_or_zero(linear * glm::dvec3(tangent));
        tangent = glm::vec4(moved == glm::dvec3(0) ? glm::vec3(tangent) : glm::vec3(moved),
                            tangent.w * static_cast<float>(sign));
    }
    if (sign < 0)
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
}

void append(Mesh& mesh, const Mesh& part) {
    const size_t before = mesh.vertex_count(), count = part.vertex_count();
    const bool bare = mesh.tangents.empty() != part.tangents.empty();
    append_values(mesh.positions, part.positions, before, count, glm::vec3(0));
    append_values(mesh.normals, part.normals, before, count, glm::vec3(0, 0, 1));
    append_values(mesh.tangents, part.tangents, before, count, glm::vec4(0));
    for (size_t set = 0; set < max_uv_sets; ++set)
        append_values(mesh.uvs[set], part.uvs[set], before, count, glm::vec2(0));
    append_values(mesh.colors, part.colors, before, count, glm::vec4(1));
    for (const uint32_t index : part.indices)
        mesh.indices.push_back(static_cast<uint32_t>(before) + index);
    for (size_t v = 0; bare && v < mesh.vertex_count(); ++v)
        if (mesh.tangents[v] == glm::vec4(0))
            mesh.tangents[v] = glm::vec4(any_perpendicular(mesh.normals[v]), 1);
}

}  // namespace wrinkle
