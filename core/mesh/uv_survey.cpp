#include "mesh/uv_survey.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

// Maximum coordinate of the baked unit square: floats resolve 1/16 there, and the corner is an int.
constexpr double max_square = 1 << 20;

// Range of the unit squares along one axis that an open interval overlaps.
struct Squares {
    double first = 0, last = -1;

    bool meets(double low, double high) const { return first <= high && last >= low; }
    bool within(double low, double high) const { return first >= low && last <= high; }
    void include(const Squares& other) {
        first = std::min(first, other.first);
        last = std::max(last, other.last);
    }
};

Squares squares_of(double a, double b, double c) {
    const auto [low, high] = std::minmax({a, b, c});
    return {std::floor(low), std::max(std::ceil(high) - 1, std::floor(low))};
}

struct Reach {
    Squares u, v;
};

Reach reach_of(const Mesh& mesh, size_t triangle) {
    const auto corner = [&](size_t k) { return mesh.uvs[0][mesh.indices[3 * triangle + k]]; };
    const glm::vec2 a = corner(0), b = corner(1), c = corner(2);
    return {squares_of(a.x, b.x, c.x), squares_of(a.y, b.y, c.y)};
}

// The UDIM tiles that triangles overlap: a two-dimensional difference array, so adding a triangle
// takes constant time (+1 at two corners of its rectangle, -1 at the other two).
class Tiles {
public:
    explicit Tiles(bool downward) : downward_(downward) {}

    // Returns false if a part of the rectangle is outside the numbered UDIM tiles.
    bool add(const Reach& reach) {
        const Squares u = reach.u;
        const Squares rows = downward_ ? Squares{-reach.v.last, -reach.v.first} : reach.v;
        if (u.meets(0, udim_columns - 1) && rows.meets(0, udim_rows - 1)) {
            const auto left = place(u.first, udim_columns), low = place(rows.first, udim_rows);
            const auto right = place(u.last + 1, udim_columns);
            const auto high = place(rows.last + 1, udim_rows);
            ++at(left, low), ++at(right, high);
            --at(right, low), --at(left, high);
        }
        return u.within(0, udim_columns - 1) && rows.within(0, udim_rows - 1);
    }

    std::vector<glm::ivec2> used() const {
        std::vector<glm::ivec2> squares;
        std::vector<int64_t> below(udim_columns);
        for (int row = 0; row < udim_rows; ++row) {
            int64_t beside = 0;
            for (int u = 0; u < udim_columns; ++u) {
                beside += changes_[static_cast<size_t>(row * (udim_columns + 1) + u)];
                int64_t& count = below[static_cast<size_t>(u)];
                count += beside;
                if (count > 0) squares.emplace_back(u, downward_ ? -row : row);
            }
        }
        return squares;
    }

private:
    static size_t place(double square, int count) {
        return static_cast<size_t>(std::clamp<double>(square, 0, count));
    }
    int64_t& at(size_t u, size_t row) { return changes_[row * (udim_columns + 1) + u]; }

    bool downward_;
    std::vector<int64_t> changes_ = std::vector<int64_t>((udim_columns + 1) * (udim_rows + 1));
};

bool is_one_square(const Reach& all) {
    return all.u.first == all.u.last && all.v.first == all.v.last &&
           all.u.within(-max_square, max_square) && all.v.within(-max_square, max_square);
}

}  // namespace

UvSurvey survey_uvs(const Mesh& mesh) {
    UvSurvey survey;
    survey.triangles = mesh.triangle_count();
    std::vector<bool> has_area(survey.triangles);
    std::optional<Reach> all;
    for (size_t t = 0; t < survey.triangles; ++t) {
        const auto map = uv_triangle(mesh, t);
        has_area[t] = map.has_value();
        if (!map) {
            ++survey.without_area;
            continue;
        }
        // The determinant of the gradients of two weights has the sign of the triangle's uv area.
        if (map->second.x * map->third.y < map->second.y * map->third.x) ++survey.mirrored;
        const Reach reach = reach_of(mesh, t);
        if (!all) all = reach;
        all->u.include(reach.u);
        all->v.include(reach.v);
    }
    if (!all) return survey;
    if (is_one_square(*all)) survey.square = {all->u.first, all->v.first};
    Tiles tiles(all->v.first < 0 && all->v.last <= 0);
    for (size_t t = 0; t < survey.triangles; ++t) {
        if (!has_area[t]) continue;
        const Reach reach = reach_of(mesh, t);
        if (reach.u.meets(survey.square.x, survey.square.x) &&
            reach.v.meets(survey.square.y, survey.square.y))
            ++survey.in_square;
        if (!tiles.add(reach)) ++survey.beyond_udim;
    }
    survey.squares = tiles.used();
    return survey;
}

}  // namespace wrinkle
