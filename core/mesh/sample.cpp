#include "mesh/sample.h"

#include <algorithm>

#include "base/text.h"
#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

double min_of(dvec3 v) {
    return std::min({v.x, v.y, v.z});
}

struct Cover {
    size_t triangle = 0;
    UvTriangle map;
};

// Rounding may leave a gap between two triangles; a triangle this near (in barycentric weight)
// counts as covering. Smaller than the margin of uv_box().
constexpr double slack = 1e-6;

// Returns the first of the triangles nth(0) to nth(count - 1) that covers uv; else the nearest one
// within `slack`; else std::nullopt.
template <class Nth>
std::optional<Cover> find_cover(const Mesh& mesh, size_t count, Nth nth, dvec2 uv) {
    std::optional<Cover> near;
    double best = -slack;
    for (size_t i = 0; i < count; ++i) {
        const size_t t = nth(i);
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

AttributePresence presence_of(const Mesh& mesh) {
    AttributePresence has;
    has.normal = !mesh.normals.empty();
    has.tangent = !mesh.tangents.empty();
    for (size_t set = 0; set < max_uv_sets; ++set)
        has.uv[set] = mesh.has_uv(set);
    has.color = !mesh.colors.empty();
    return has;
}

SurfacePoint point_of(const Mesh& mesh, const Cover& cover, dvec2 uv, uint32_t size) {
    const uint32_t* corners = mesh.indices.data() + 3 * cover.triangle;
    SurfacePoint point;
    point.value = blend_all(mesh, corners, cover.map.weights(uv));
    point.dx = blend_all(mesh, corners, cover.map.du() / static_cast<double>(size));
    point.dy = blend_all(mesh, corners, cover.map.dv() / static_cast<double>(size));
    const double texel = 1.0 / size;
    point.value.uv[0] = uv;
    point.dx.uv[0] = {texel, 0};
    point.dy.uv[0] = {0, texel};
    point.has = presence_of(mesh);
    point.triangle = static_cast<uint32_t>(cover.triangle);
    return point;
}

}  // namespace

std::optional<SurfacePoint> sample_mesh(const Mesh& mesh, dvec2 uv, uint32_t size,
                                        Diagnostics& diagnostics) {
    if (!mesh.has_uv(0)) {
        diagnostics.error("the mesh has no uvs (set 0)", "a mesh with a uv layout");
        return std::nullopt;
    }
    if (size == 0) {
        diagnostics.error("the size of the uv layout is 0", "at least 1 texel");
        return std::nullopt;
    }
    const std::optional<Cover> cover = find_cover(
        mesh, mesh.triangle_count(), [](size_t i) { return i; }, uv);
    if (!cover) {
        diagnostics.error("no triangle of the mesh covers the uv (" + shortest(uv.x) + ", " +
                              shortest(uv.y) + ")",
                          "a place inside its uv layout");
        return std::nullopt;
    }
    return point_of(mesh, *cover, uv, size);
}

std::optional<SurfacePoint> sample_mesh(const Mesh& mesh, const UvGrid& grid, dvec2 uv,
                                        uint32_t size) {
    const std::span<const uint32_t> near = grid.near(uv);
    const std::optional<Cover> cover = find_cover(
        mesh, near.size(), [&](size_t i) { return near[i]; }, uv);
    if (!cover) return {};
    return point_of(mesh, *cover, uv, size);
}

}  // namespace wrinkle
