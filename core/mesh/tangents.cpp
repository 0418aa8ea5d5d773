#include "mesh/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

using Corners = std::array<uint32_t, 3>;

Corners corners_of(const Mesh& mesh, size_t triangle) {
    return {mesh.indices[3 * triangle], mesh.indices[3 * triangle + 1],
            mesh.indices[3 * triangle + 2]};
}

dvec3 unit_or_zero(dvec3 v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return dvec3(0);
    const dvec3 scaled = v / largest;  // so that no length under- or overflows
    return scaled / glm::length(scaled);
}

dvec3 in_plane(dvec3 v, dvec3 normal) {
    return unit_or_zero(v - glm::dot(normal, v) * normal);
}

struct FaceTangent {
    dvec3 direction{0};  // of increasing u; zero when the triangle has no area
    double sign = 0;     // of the uv orientation
};

FaceTangent face_tangent(const Mesh& mesh, const Corners& c) {
    const auto& uv = mesh.uvs[0];
    const dvec3 p1 = dvec3(mesh.positions[c[1]]) - dvec3(mesh.positions[c[0]]);
    const dvec3 p2 = dvec3(mesh.positions[c[2]]) - dvec3(mesh.positions[c[0]]);
    const dvec2 d1 = dvec2(uv[c[1]]) - dvec2(uv[c[0]]);
    const dvec2 d2 = dvec2(uv[c[2]]) - dvec2(uv[c[0]]);
    const double determinant = d1.x * d2.y - d2.x * d1.y;
    const bool flat = unit_or_zero(glm::cross(unit_or_zero(p1), unit_or_zero(p2))) == dvec3(0);
    if (flat || !std::isfinite(determinant) || determinant == 0) return {};
    const double sign = determinant > 0 ? 1 : -1;
    return {unit_or_zero(sign * (p1 * d2.y - p2 * d1.y)), sign};
}

double corner_angle(const Mesh& mesh, const Corners& c, size_t k, dvec3 normal) {
    const dvec3 at = mesh.positions[c[k]];
    const dvec3 a = in_plane(dvec3(mesh.positions[c[(k + 1) % 3]]) - at, normal);
    const dvec3 b = in_plane(dvec3(mesh.positions[c[(k + 2) % 3]]) - at, normal);
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
}

dvec3 any_perpendicular(dvec3 normal) {
    const dvec3 axis = std::abs(normal.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 result = in_plane(axis, normal);
    return result == dvec3(0) ? dvec3(1, 0, 0) : result;
}

// What the triangles of one orientation contribute to a vertex.
struct Sum {
    dvec3 direction{0};
    bool used = false;
};

void accumulate(const Mesh& mesh, const Corners& c, const FaceTangent& face,
                std::vector<Sum>& sums) {
    for (size_t k = 0; k < 3; ++k) {
        const dvec3 normal = unit_or_zero(mesh.normals[c[k]]);
        Sum& sum = sums[c[k]];
        sum.direction += corner_angle(mesh, c, k, normal) * in_plane(face.direction, normal);
        sum.used = true;
    }
}

glm::vec4 tangent_of(const Sum& sum, glm::vec3 vertex_normal, float sign) {
    const dvec3 normal = unit_or_zero(vertex_normal);
    dvec3 direction = in_plane(sum.direction, normal);
    if (direction == dvec3(0)) direction = any_perpendicular(normal);
    return {glm::vec3(direction), sign};
}

// Vertices that triangles of both orientations use: a copy for the negative ones.
std::vector<uint32_t> split_vertices(Mesh& mesh, const std::vector<Sum>& positive,
                                     const std::vector<Sum>& negative) {
    std::vector<uint32_t> mirrored(positive.size());
    for (uint32_t v = 0; v < positive.size(); ++v)
        mirrored[v] = positive[v].used && negative[v].used ? copy_vertex(mesh, v) : v;
    return mirrored;
}

void assign(Mesh& mesh, const std::vector<Sum>& positive, const std::vector<Sum>& negative,
            const std::vector<uint32_t>& mirrored) {
    mesh.tangents.resize(mesh.vertex_count());
    for (size_t v = 0; v < positive.size(); ++v) {
        const glm::vec3 normal = mesh.normals[v];
        if (positive[v].used || !negative[v].used)
            mesh.tangents[v] = tangent_of(positive[v], normal, 1);
        if (negative[v].used) mesh.tangents[mirrored[v]] = tangent_of(negative[v], normal, -1);
    }
}

}  // namespace

bool make_tangents(Mesh& mesh) {
    if (!mesh.has_uv(0) || mesh.normals.empty()) return false;
    mesh.tangents.clear();
    std::vector<Sum> positive(mesh.vertex_count());
    std::vector<Sum> negative(mesh.vertex_count());
    std::vector<bool> is_mirrored(mesh.triangle_count());
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        const Corners c = corners_of(mesh, t);
        const FaceTangent face = face_tangent(mesh, c);
        is_mirrored[t] = face.sign < 0;
        if (face.sign != 0) accumulate(mesh, c, face, is_mirrored[t] ? negative : positive);
    }
    const std::vector<uint32_t> mirrored = split_vertices(mesh, positive, negative);
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        if (is_mirrored[i / 3]) mesh.indices[i] = mirrored[mesh.indices[i]];
    assign(mesh, positive, negative, mirrored);
    return true;
}

void ensure_tangents(Mesh& mesh) {
    if (mesh.tangents.empty()) make_tangents(mesh);
}

}  // namespace wrinkle
