#include "mesh/vertex_frames.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/weld.h"

namespace wrinkle {
namespace {

using glm::dvec3;

std::vector<dvec3> smooth_normals(const Mesh& mesh, const std::vector<uint32_t>& welded) {
    std::vector<dvec3> sums(mesh.vertex_count(), dvec3(0));
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        const uint32_t* c = mesh.indices.data() + 3 * t;
        const dvec3 p[3] = {mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]};
        const dvec3 normal = unit_or_zero(glm::cross(p[1] - p[0], p[2] - p[0]));
        for (size_t k = 0; k < 3; ++k) {
            const dvec3 a = unit_or_zero(p[(k + 1) % 3] - p[k]);
            const dvec3 b = unit_or_zero(p[(k + 2) % 3] - p[k]);
            sums[welded[c[k]]] += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * normal;
        }
    }
    return sums;
}

}  // namespace

size_t complete_normals(Mesh& mesh) {
    const bool had = !mesh.normals.empty();
    mesh.normals.resize(mesh.vertex_count(), glm::vec3(0));
    std::vector<uint32_t> bad;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const dvec3 unit = unit_or_zero(mesh.normals[v]);
        if (unit == dvec3(0)) bad.push_back(v);
        mesh.normals[v] = unit;
    }
    if (bad.empty()) return 0;
    const std::vector<uint32_t> welded = weld_positions(mesh);
    const std::vector<dvec3> sums = smooth_normals(mesh, welded);
    for (const uint32_t v : bad) {
        const dvec3 unit = unit_or_zero(sums[welded[v]]);
        mesh.normals[v] = unit == dvec3(0) ? glm::vec3(0, 0, 1) : glm::vec3(unit);
    }
    return had ? bad.size() : 0;
}

}  // namespace wrinkle
