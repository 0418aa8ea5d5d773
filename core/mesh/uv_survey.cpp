#include "mesh/uv_survey.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

// Maximum coordinate of the baked unit square: floats resolve 1/16 there, and the corner is an int.
constexpr double max_square = 1 << 20;

// Range of the unit squares along one axis that an open interval overlaps.
struct SquareRange {
    double first = 0, last = -1;

    bool overlaps(double low, double high) const { return first <= high && last >= low; }
    bool within(double low, double high) const { return first >= low && last <= high; }
    void include(const SquareRange& other) {
        first = std::min(first, other.first);
        last = std::max(last, other.last);
    }
};

SquareRange squares_between(double a, double b, double c) {
    const auto [low, high] = std::minmax({a, b, c});
    return {std::floor(low), std::max(std::ceil(high) - 1, std::floor(low))};
}

struct SquareBox {
    SquareRange u, v;
};

SquareBox squares_of(const Mesh& mesh, size_t triangle) {
    const auto corner = [&](size_t k) { return mesh.uvs[0][mesh.indices[3 * triangle + k]]; };
    const glm::vec2 a = corner(0), b = corner(1), c = corner(2);
    return {squares_between(a.x, b.x, c.x), squares_between(a.y, b.y, c.y)};
}

// The UDIM tiles that triangles overlap, one bit per tile. A triangle takes at most udim_rows
// steps.
class UsedTiles {
public:
    explicit UsedTiles(bool downward) : downward_(downward) {}

    // Returns false if a part of the box is outside the numbered UDIM tiles.
    bool add(const SquareBox& box) {
        const SquareRange rows = downward_ ? SquareRange{-box.v.last, -box.v.first} : box.v;
        std::bitset<udim_columns> columns;
        for (int u = 0; u < udim_columns; ++u)
            columns[static_cast<size_t>(u)] = box.u.overlaps(u, u);
        const auto first = static_cast<size_t>(std::clamp<double>(rows.first, 0, udim_rows));
        const auto end = static_cast<size_t>(std::clamp<double>(rows.last + 1, 0, udim_rows));
        for (size_t row = first; row < end; ++row)
            used_[row] |= columns;
        return box.u.within(0, udim_columns - 1) && rows.within(0, udim_rows - 1);
    }

    std::vector<glm::ivec2> tiles() const {
        std::vector<glm::ivec2> tiles;
        for (int row = 0; row < udim_rows; ++row)
            for (int u = 0; u < udim_columns; ++u)
                if (used_[static_cast<size_t>(row)][static_cast<size_t>(u)])
                    tiles.emplace_back(u, downward_ ? -row : row);
        return tiles;
    }

private:
    bool downward_;
    std::array<std::bitset<udim_columns>, udim_rows> used_;
};

bool is_one_square(const SquareBox& all) {
    return all.u.first == all.u.last && all.v.first == all.v.last &&
           all.u.within(-max_square, max_square) && all.v.within(-max_square, max_square);
}

}  // namespace

UvSurvey survey_uvs(const Mesh& mesh) {
    UvSurvey survey;
    survey.triangles = mesh.triangle_count();
    std::vector<bool> has_area(survey.triangles);
    std::optional<SquareBox> all;
    for (size_t t = 0; t < survey.triangles; ++t) {
        const auto map = uv_triangle(mesh, t);
        has_area[t] = map.has_value();
        if (!map) {
            ++survey.without_area;
            continue;
        }
        // The determinant of the gradients of two weights has the sign of the triangle's uv area.
        if (map->second.x * map->third.y < map->second.y * map->third.x) ++survey.mirrored;
        const SquareBox box = squares_of(mesh, t);
        if (!all) all = box;
        all->u.include(box.u);
        all->v.include(box.v);
    }
    if (!all) return survey;
    if (is_one_square(*all)) survey.square = {all->u.first, all->v.first};
    UsedTiles used(all->v.first < 0 && all->v.last <= 0);
    for (size_t t = 0; t < survey.triangles; ++t) {
        if (!has_area[t]) continue;
        const SquareBox box = squares_of(mesh, t);
        if (box.u.overlaps(survey.square.x, survey.square.x) &&
            box.v.overlaps(survey.square.y, survey.square.y))
            ++survey.in_square;
        if (!used.add(box)) ++survey.beyond_udim;
    }
    survey.udim_tiles = used.tiles();
    return survey;
}

double uv_length(const Mesh& mesh) {
    if (!mesh.has_uv(0)) return 0;
    double area = 0, uv_area = 0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        const uint32_t* corner = mesh.indices.data() + 3 * t;
        const glm::dvec3 a = mesh.positions[corner[0]], b = mesh.positions[corner[1]],
                         c = mesh.positions[corner[2]];
        const glm::dvec2 p = mesh.uvs[0][corner[0]], q = mesh.uvs[0][corner[1]],
                         r = mesh.uvs[0][corner[2]];
        area += glm::length(glm::cross(b - a, c - a));
        uv_area += std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
    }
    return uv_area > 0 ? std::sqrt(area / uv_area) : 0;
}

}  // namespace wrinkle
