#include "mesh/uv_survey.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

constexpr int udim_side = 10;

// The whole numbers whose squares the open interval reaches into.
struct Squares {
    double first, last;
    bool within(double count) const { return first >= 0 && last < count; }
};

Squares squares_of(double a, double b, double c) {
    const auto [low, high] = std::minmax({a, b, c});
    return {std::floor(low), std::max(std::ceil(high) - 1, std::floor(low))};
}

}  // namespace

UvSurvey survey_uvs(const Mesh& mesh) {
    UvSurvey survey;
    survey.triangles = mesh.triangle_count();
    std::array<bool, udim_side * udim_side> used{};
    for (size_t t = 0; t < survey.triangles; ++t) {
        const auto map = uv_triangle(mesh, t);
        if (!map) {
            ++survey.without_area;
            continue;
        }
        const auto corner = [&](size_t k) { return mesh.uvs[0][mesh.indices[3 * t + k]]; };
        const glm::vec2 a = corner(0), b = corner(1), c = corner(2);
        // The gradients of two weights turn as the triangle does.
        if (map->second.x * map->third.y < map->second.y * map->third.x) ++survey.mirrored;
        const Squares u = squares_of(a.x, b.x, c.x), v = squares_of(a.y, b.y, c.y);
        if (u.first <= 0 && u.last >= 0 && v.first <= 0 && v.last >= 0) ++survey.first_square;
        if (!u.within(udim_side) || !v.within(udim_side)) ++survey.beyond_udim;
        for (double j = std::max(v.first, 0.0); j <= std::min<double>(v.last, udim_side - 1); ++j)
            for (double i = std::max(u.first, 0.0); i <= std::min<double>(u.last, udim_side - 1);
                 ++i)
                used[static_cast<size_t>(j * udim_side + i)] = true;
    }
    for (int i = 0; i < udim_side * udim_side; ++i)
        if (used[static_cast<size_t>(i)]) survey.squares.emplace_back(i % udim_side, i / udim_side);
    return survey;
}

}  // namespace wrinkle
