// A mesh: indexed triangles over parallel vertex arrays.
//
// Everything is in object space, right-handed; uv origin bottom left. `positions` sets the number
// of vertices; every other array is empty (the mesh has no such attribute) or has that size. Seen
// from the side its normal points to, a triangle's corners run counter-clockwise.
//
// `normals` are unit, tangents too: xyz along increasing u of uv0, at right angles to the normal,
// w = +1 or -1 so that w * cross(normal, tangent) runs along increasing v. Interpolate normal and
// tangent as they are and build the bitangent from the interpolated vectors, neither normalised:
// that is MikkTSpace's convention.
//
// `displaced` is where a displaced surface is drawn. Everything else, `positions` too, stays that
// of the surface before: a material is made there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace wrinkle {

constexpr size_t max_uv_sets = 4;

struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
    std::array<std::vector<glm::vec2>, max_uv_sets> uvs;
    std::vector<glm::vec4> colors;
    std::vector<glm::vec3> displaced;
    std::vector<uint32_t> indices;  // three per triangle

    size_t vertex_count() const { return positions.size(); }
    size_t triangle_count() const { return indices.size() / 3; }
    const std::vector<glm::vec3>& drawn() const {
        return displaced.empty() ? positions : displaced;
    }
    bool has_uv(size_t set) const { return set < max_uv_sets && !uvs[set].empty(); }
};

struct Bounds {
    glm::vec3 low{0};
    glm::vec3 high{0};

    glm::vec3 center() const { return (low + high) * 0.5F; }
};

Bounds bounds_of(const Mesh& mesh);  // of what is drawn of triangles; zero for none

// Appends a copy of vertex `index` with all attributes the mesh has; returns its number.
uint32_t copy_vertex(Mesh& mesh, uint32_t index);

}  // namespace wrinkle
