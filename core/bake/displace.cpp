#include "bake/displace.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

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

template <class Vector>
void fill(PointSet& set, const Mesh& mesh, const std::vector<int64_t>& corners, InputNeed need,
          const std::vector<Vector>& values) {
    std::vector<double>& target = set.at(need.input, need.variant);
    for (uint32_t vertex = 0; vertex < values.size(); ++vertex) {
        const auto step = static_cast<size_t>(need.variant);
        const uint32_t other = step > 0 ? neighbour(mesh, corners, vertex, step) : vertex;
        for (int lane = 0; lane < Vector::length(); ++lane) {
            const double here = values[vertex][lane];
            target.push_back(step > 0 ? values[other][lane] - here : here);
        }
    }
}

void fill(PointSet& set, const Mesh& mesh, const std::vector<int64_t>& corners, InputNeed need) {
    switch (need.input) {
        case SurfaceInput::position_:
            return fill(set, mesh, corners, need, mesh.positions);
        case SurfaceInput::normal_:
        case SurfaceInput::view_:
            return fill(set, mesh, corners, need, mesh.normals);
        case SurfaceInput::tangent_:
            return fill(set, mesh, corners, need, mesh.tangents);
        case SurfaceInput::color0_:
            return fill(set, mesh, corners, need, mesh.colors);
        case SurfaceInput::facing_:
            set.at(need.input, need.variant)
                .assign(mesh.vertex_count(), need.variant == Variant::value ? 1 : 0);
            return;
        default:
            break;
    }
    const size_t uv = static_cast<size_t>(need.input) - static_cast<size_t>(SurfaceInput::uv0_);
    if (uv < max_uv_sets) fill(set, mesh, corners, need, mesh.uvs[uv]);
}

using Place = std::array<uint32_t, 3>;  // bit patterns of the coordinates

void join_seams(Mesh& mesh) {
    struct Sum {
        glm::dvec3 sum{0};
        double count = 0;
    };
    std::map<Place, Sum> places;
    const auto place = [&](size_t i) {
        const glm::vec3 p = mesh.positions[i] + 0.0F;  // -0 equals 0
        return Place{std::bit_cast<uint32_t>(p.x), std::bit_cast<uint32_t>(p.y),
                     std::bit_cast<uint32_t>(p.z)};
    };
    for (size_t i = 0; i < mesh.vertex_count(); ++i) {
        Sum& sum = places[place(i)];
        sum.sum += glm::dvec3(mesh.displaced[i]);
        sum.count += 1;
    }
    for (size_t i = 0; i < mesh.vertex_count(); ++i) {
        const Sum& sum = places[place(i)];
        if (sum.count > 1) mesh.displaced[i] = glm::vec3(sum.sum / sum.count);
    }
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
    const PointSet points = vertex_points(mesh, program);
    for (const InputNeed& need : needed_inputs(program))
        if (points.at(need.input, need.variant).empty() && points.count > 0)
            return "the displacement reads '" + std::string(info(need.input).name) +
                   "', which the mesh lacks";
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
