// A mesh: indexed triangles over parallel vertex arrays.
//
// All data is in object space, right-handed; the uv origin is bottom left. `positions` sets the
// number of vertices; every other array has the same size, or is empty if the mesh lacks the
// attribute. Seen from the side that the normal points to, the corners of a triangle run
// counter-clockwise.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace wrinkle {

constexpr size_t max_uv_sets = 4;

// `normals` and `tangents` are unit. Tangent xyz points along increasing u of uv0, perpendicular to
// the normal; w = +1 or -1 so that w * cross(normal, tangent) points along increasing v.
// MikkTSpace's convention: interpolate normal and tangent without normalising them, and compute the
// bitangent from the interpolated vectors.
//
// `displaced` holds the positions at which a displaced surface is drawn. All other arrays,
// including `positions`, describe the undisplaced surface, on which materials are evaluated.
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

// Calls use(values) for each vertex array of the mesh; arrays of absent attributes are empty.
template <typename Use>
void each_vertex_array(Mesh& mesh, Use use) {
    use(mesh.positions);
    use(mesh.normals);
    use(mesh.tangents);
    for (auto& uvs : mesh.uvs)
        use(uvs);
    use(mesh.colors);
    use(mesh.displaced);
}

struct Bounds {
    glm::vec3 low{0};
    glm::vec3 high{0};

    glm::vec3 center() const { return (low + high) * 0.5F; }
};

Bounds bounds_of(const Mesh& mesh);  // box of the drawn positions of all triangles; zero if empty

// Transforms positions by M, normals by cof(M) times the sign of det(M), tangents by M. If M
// mirrors, the corner order of triangles and tangent.w are reversed, so that the outside stays
// outside. Normals and tangents are normalised; those that M maps to zero are unchanged.
// Precondition, as of append(): `displaced` is empty.
void transform(Mesh& mesh, const glm::dmat4& m);

// Appends `part` to `mesh`. The result has every attribute that at least one of them has; vertices
// that lack it get uv (0, 0), white, or a tangent perpendicular to their normal with w = 1.
void append(Mesh& mesh, const Mesh& part);

// Returns the mesh with smaller triangles and the same surface: every edge longer than `longest` is
// split at its midpoint, repeatedly. Midpoint attributes are the mean of both ends; normals and
// tangents are normalised. The split depends only on the two ends of an edge, so triangles that
// share an edge or a uv seam still match. Facets stay flat. A pass splits a triangle into at most
// four; a pass that could exceed `max_triangles` is not begun. Returns the mesh unchanged if
// longest <= 0 or NaN.
Mesh subdivided(Mesh mesh, float longest, size_t max_triangles = 1'000'000);

}  // namespace wrinkle
