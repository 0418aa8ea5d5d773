#include "bake/displace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "bake/mesh_check.h"
#include "mesh/weld.h"

#include "ir/op.h"

namespace wrinkle {
namespace {

// neighbours[step][vertex] is the vertex `step` corners (0, 1 or 2) after `vertex` in the first of
// its triangles, or `vertex` if no triangle uses it. The difference of their values is the
// differential.
using Neighbours = std::array<std::vector<uint32_t>, 3>;

Neighbours neighbours_of(const Mesh& mesh) {
    std::vector<uint32_t> self(mesh.vertex_count());
    std::iota(self.begin(), self.end(), 0U);
    Neighbours result{self, self, self};
    for (size_t i = mesh.indices.size(); i-- > 0;)
        for (const size_t step : {1, 2})
            result[step][mesh.indices[i]] = mesh.indices[i - i % 3 + (i + step) % 3];
    return result;
}

void fill(PointSet& set, const Mesh& mesh, const Neighbours& neighbours, InputNeed need) {
    std::vector<double>& target = set.at(need.input, need.variant);
    const auto step = static_cast<size_t>(need.variant);
    if (need.input == SurfaceInput::facing_) {
        target.assign(mesh.vertex_count(), step == 0 ? 1 : 0);
        return;
    }
    const auto [values, stride] = attribute_of(mesh, need.input);
    for (uint32_t vertex = 0; values && vertex < mesh.vertex_count(); ++vertex) {
        const float* here = values + size_t{vertex} * stride;
        const float* other = values + size_t{neighbours[step][vertex]} * stride;
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
    const Neighbours neighbours = neighbours_of(mesh);
    for (const InputNeed& need : needed_inputs(program))
        fill(set, mesh, neighbours, need);
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
    if (!std::ranges::all_of(heights, [](double h) { return std::isfinite(h); }))
        return "a displacement is not finite";
    mesh.displaced.clear();
    for (size_t i = 0; i < mesh.vertex_count(); ++i)
        mesh.displaced.push_back(mesh.positions[i] +
                                 mesh.normals[i] * static_cast<float>(heights[i]));
    join_seams(mesh);
    return "";
}

}  // namespace wrinkle
