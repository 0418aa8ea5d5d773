#include "bake/displace.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bake/mesh_check.h"
#include "mesh/weld.h"

#include "ir/op.h"

namespace wrinkle {
namespace {

// Returns, for each vertex, the index of one triangle corner that uses it, or -1.
std::vector<int64_t> first_corners(const Mesh& mesh) {
    std::vector<int64_t> corners(mesh.vertex_count(), -1);
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        if (corners[mesh.indices[i]] < 0) corners[mesh.indices[i]] = static_cast<int64_t>(i);
    return corners;
}

// Returns the vertex `step` corners after `vertex` in one of its triangles, or `vertex` if no
// triangle uses it. The difference of their values is the differential.
uint32_t neighbour(const Mesh& mesh, const std::vector<int64_t>& corners, uint32_t vertex,
                   size_t step) {
    if (corners[vertex] < 0) return vertex;
    const auto corner = static_cast<size_t>(corners[vertex]);
    return mesh.indices[corner - corner % 3 + (corner + step) % 3];
}

void fill(PointSet& set, const Mesh& mesh, const std::vector<int64_t>& corners, InputNeed need) {
    std::vector<double>& target = set.at(need.input, need.variant);
    const auto step = static_cast<size_t>(need.variant);
    if (need.input == SurfaceInput::facing_) {
        target.assign(mesh.vertex_count(), step == 0 ? 1 : 0);
        return;
    }
    const auto [values, stride] = attribute_of(mesh, need.input);
    for (uint32_t vertex = 0; values && vertex < mesh.vertex_count(); ++vertex) {
        const float* here = values + size_t{vertex} * stride;
        const float* other = values + size_t{neighbour(mesh, corners, vertex, step)} * stride;
        for (uint32_t lane = 0; lane < stride; ++lane)
            target.push_back(step > 0 ? other[lane] - double{here[lane]} : here[lane]);
    }
}

void join_seams(Mesh& mesh) {
    const std::vector<uint32_t> first = weld_positions(mesh);
    std::vector<glm::dvec3> sums(first.size(), glm::dvec3(0));
    std::vector<double> counts(first.size());
    for (size_t i = 0; i < first.size(); ++i) {
        sums[first[i]] += glm::dvec3(mesh.displaced[i]);
        counts[first[i]] += 1;
    }
    for (size_t i = 0; i < first.size(); ++i)
        if (counts[first[i]] > 1) mesh.displaced[i] = glm::vec3(sums[first[i]] / counts[first[i]]);
}

}  // namespace

PointSet vertex_points(const Mesh& mesh, const Program& program) {
    PointSet set;
    set.count = mesh.vertex_count();
    const std::vector<int64_t> corners = first_corners(mesh);
    for (const InputNeed& need : needed_inputs(program))
        fill(set, mesh, corners, need);
    return set;
}

std::string displace(Mesh& mesh, const Program& program, size_t output,
                     std::span<const Texture> textures) {
    if (mesh.normals.empty()) return "a mesh without normals cannot be displaced";
    const std::string missing = missing_input(mesh, program);
    if (!missing.empty()) return "the displacement reads '" + missing + "', which the mesh lacks";
    const PointSet points = vertex_points(mesh, program);
    Results results = make_results(program, points.count);
    evaluate<float>(program, points, textures, 0, points.count, results);
    const std::vector<double>& heights = results.values[output];
    if (!std::all_of(heights.begin(), heights.end(), [](double h) { return std::isfinite(h); }))
        return "a displacement is not finite";
    mesh.displaced.clear();
    for (size_t i = 0; i < mesh.vertex_count(); ++i)
        mesh.displaced.push_back(mesh.positions[i] +
                                 mesh.normals[i] * static_cast<float>(heights[i]));
    join_seams(mesh);
    return "";
}

}  // namespace wrinkle
