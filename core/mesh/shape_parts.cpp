#include "mesh/shape_parts.h"

#include <cmath>

namespace wrinkle {

uint32_t add_vertex(Mesh& mesh, const ShapeVertex& vertex) {
    mesh.positions.push_back(vertex.position);
    mesh.normals.push_back(vertex.normal);
    mesh.tangents.push_back(glm::vec4(vertex.tangent, 1));
    mesh.uvs[0].push_back(vertex.uv);
    const glm::vec2 p = vertex.uv - 0.5F;
    const glm::vec2 turned(std::sqrt(3.0F) / 2 * p.x - p.y / 2,
                           p.x / 2 + std::sqrt(3.0F) / 2 * p.y);
    mesh.uvs[1].push_back(0.5F + 2.0F * turned);
    mesh.colors.push_back(glm::vec4(1));
    return static_cast<uint32_t>(mesh.vertex_count() - 1);
}

void add_triangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

}  // namespace wrinkle
