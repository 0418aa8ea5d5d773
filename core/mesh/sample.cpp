#include "mesh/sample.h"

#include <algorithm>

#include "mesh/uv_grid.h"
#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

double min_of(dvec3 v) {
    return std::min({v.x, v.y, v.z});
}

struct Cover {
    uint32_t triangle = 0;
    UvTriangle map;
};

// Rounding may leave a gap between two triangles; a triangle this near (in barycentric weight)
// counts as covering. Smaller than the margin of uv_box().
constexpr double slack = 1e-6;

// Returns the first of the triangles that covers uv; else the nearest one within `slack`; else
// std::nullopt.
std::optional<Cover> find_cover(const Mesh& mesh, std::span<const uint32_t> triangles, dvec2 uv) {
    std::optional<Cover> near;
    double best = -slack;
    for (const uint32_t t : triangles) {
        if (!uv_box(mesh, t).contains(uv)) continue;
        const std::optional<UvTriangle> map = uv_triangle(mesh, t);
        if (!map) continue;
        const double inside = min_of(map->weights(uv));
        if (inside >= 0) return Cover{t, *map};
        if (inside > best) {
            best = inside;
            near = Cover{t, *map};
        }
    }
    return near;
}

template <typename Result, typename T>
Result blend_corners(const std::vector<T>& values, const uint32_t* corners, dvec3 weights) {
    if (values.empty()) return Result(0);
    return blend<Result>(values[corners[0]], values[corners[1]], values[corners[2]], weights);
}

SurfaceAttributes blend_all(const Mesh& mesh, const uint32_t* corners, dvec3 weights) {
    SurfaceAttributes result;
    result.position = blend_corners<dvec3>(mesh.positions, corners, weights);
    result.normal = blend_corners<dvec3>(mesh.normals, corners, weights);
    result.tangent = blend_corners<glm::dvec4>(mesh.tangents, corners, weights);
    for (size_t set = 0; set < max_uv_sets; ++set)
        result.uv[set] = blend_corners<dvec2>(mesh.uvs[set], corners, weights);
    result.color = blend_corners<glm::dvec4>(mesh.colors, corners, weights);
    return result;
}

SurfacePoint point_of(const Mesh& mesh, const Cover& cover, dvec2 uv, uint32_t size) {
    const uint32_t* corners = mesh.indices.data() + 3 * size_t{cover.triangle};
    SurfacePoint point;
    point.value = blend_all(mesh, corners, cover.map.weights(uv));
    point.dx = blend_all(mesh, corners, cover.map.du() / static_cast<double>(size));
    point.dy = blend_all(mesh, corners, cover.map.dv() / static_cast<double>(size));
    const double texel = 1.0 / size;
    point.value.uv[0] = uv;
    point.dx.uv[0] = {texel, 0};
    point.dy.uv[0] = {0, texel};
    point.triangle = cover.triangle;
    return point;
}

}  // namespace

std::optional<SurfacePoint> sample_mesh(const Mesh& mesh, std::span<const uint32_t> triangles,
                                        dvec2 uv, uint32_t size) {
    const std::optional<Cover> cover = find_cover(mesh, triangles, uv);
    if (!cover) return {};
    return point_of(mesh, *cover, uv, size);
}

}  // namespace wrinkle
