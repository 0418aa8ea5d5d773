// Martin Newell's teapot of 1975, tessellated from its published bicubic Bezier patches (Crow, "The
// Origins of the Teapot", IEEE CG&A 7(1), 1987), including the bottom that was added later.
//
// 24 of the 32 patches are quarters of surfaces of revolution and are defined by their profiles.
// The inner control points of a quarter circle are offset by 0.56 of the radius, not by the 0.5523
// of the best approximation. The other eight patches are the halves of handle and spout: each row
// of control points is: inner point, inner point moved sideways by the width, outer point moved
// sideways by the width, outer point.
#include <array>
#include <glm/geometric.hpp>

#include "mesh/shape_parts.h"

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int quarter_columns = 16;
constexpr double circle_handle = 0.56;
constexpr double scale = 0.45;  // relative to the published coordinates

// A surface of revolution: the control points of its profile (radius, height), from bottom to top.
struct Band {
    std::array<dvec2, 4> profile;
    int rows;
    double v0, v1;
};

// clang-format off
constexpr std::array<Band, 6> bands{{
    {{{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}}, 10, 0, 0.14},                  // bottom
    {{{{1.5, 0.15}, {1.5, 0.225}, {2, 0.45}, {2, 0.9}}}, 12, 0.14, 0.26},              // body
    {{{{2, 0.9}, {2, 1.35}, {1.75, 1.875}, {1.5, 2.4}}}, 16, 0.26, 0.48},
    {{{{1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125}, {1.4, 2.4}}}, 10, 0.48, 0.54},  // rim
    {{{{1.3, 2.4}, {1.3, 2.55}, {0.4, 2.55}, {0.2, 2.7}}}, 12, 0.56, 0.70},            // lid
    {{{{0.2, 2.7}, {0, 2.85}, {0.8, 3.15}, {0, 3.15}}}, 16, 0.70, 0.82},
}};

// A cross-section of a tube in the plane y = 0 of the published coordinates.
struct Section {
    dvec2 inner, outer;  // (x, height)
    double width;
};
using Tube = std::array<Section, 7>;  // two patches that share the fourth section

constexpr Tube handle{{
    {{-1.6, 2.025}, {-1.5, 2.25}, 0.3}, {{-2.3, 2.025}, {-2.5, 2.25}, 0.3},
    {{-2.7, 2.025}, {-3, 2.25}, 0.3}, {{-2.7, 1.8}, {-3, 1.8}, 0.3},
    {{-2.7, 1.575}, {-3, 1.35}, 0.3}, {{-2.5, 1.125}, {-2.65, 0.9375}, 0.3},
    {{-2, 0.9}, {-1.9, 0.6}, 0.3}}};
constexpr Tube spout{{
    {{1.7, 1.425}, {1.7, 0.6}, 0.66}, {{2.6, 1.425}, {3.1, 0.825}, 0.66},
    {{2.3, 2.1}, {2.4, 2.025}, 0.25}, {{2.7, 2.4}, {3.3, 2.4}, 0.25},
    {{2.8, 2.475}, {3.525, 2.49375}, 0.25}, {{2.9, 2.475}, {3.45, 2.5125}, 0.15},
    {{2.8, 2.4}, {3.2, 2.4}, 0.15}}};
// clang-format on

struct CurvePoint {
    dvec3 value;
    dvec3 slope;  // per unit of t
};

CurvePoint bezier(const std::array<dvec3, 4>& p, double t) {
    const double s = 1 - t;
    return {s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3],
            3.0 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]))};
}

// A quarter of the unit circle around +y; it begins at longitude turn / 4, seam at -z.
CurvePoint quarter_circle(int turn, double t) {
    constexpr std::array<dvec3, 4> corners{dvec3(0, 0, -1), dvec3(-1, 0, 0), dvec3(0, 0, 1),
                                           dvec3(1, 0, 0)};
    const dvec3 a = corners[static_cast<size_t>(turn % 4)];
    const dvec3 b = corners[static_cast<size_t>((turn + 1) % 4)];
    return bezier({a, a + circle_handle * b, b + circle_handle * a, b}, t);
}

ShapeVertex vertex_of(dvec3 position, dvec3 along_u, dvec3 along_v, dvec2 uv) {
    const dvec3 normal = glm::normalize(glm::cross(along_u, along_v));
    return {scale * position, normal, glm::normalize(along_u), uv};
}

ShapeVertex band_vertex(const Band& band, double column, int row) {
    constexpr int columns = 4 * quarter_columns;
    const int turn = static_cast<int>(column) / quarter_columns;
    const CurvePoint around =
        quarter_circle(turn, column / quarter_columns - static_cast<double>(turn));
    std::array<dvec3, 4> profile;
    for (size_t k = 0; k < 4; ++k)
        profile[k] = dvec3(band.profile[k], 0);
    const double t = static_cast<double>(row) / band.rows;
    const auto [p, slope] = bezier(profile, t);
    const dvec3 up = slope.x * around.value + dvec3(0, slope.y, 0);
    return vertex_of(p.x * around.value + dvec3(0, p.y, 0), around.slope, up,
                     {column / columns, band.v0 + (band.v1 - band.v0) * t});
}

void add_band(Mesh& mesh, const Band& band) {
    add_revolution(mesh, 4 * quarter_columns, band.rows, band.profile[0].x == 0,
                   band.profile[3].x == 0,
                   [&](double column, int row) { return band_vertex(band, column, row); });
}

// A control point of half a cross-section, from the inner to the outer point; side +1 bulges to +z.
dvec3 section_point(const Section& section, size_t k, double side) {
    const dvec2 p = k < 2 ? section.inner : section.outer;
    return {p.x, p.y, k == 1 || k == 2 ? side * section.width : 0};
}

// u runs along the tube. v runs around it: from the inner line over one side to the outer line, and
// back over the other side. The first side is -z, which makes the outside front-facing.
ShapeVertex tube_vertex(const Tube& tube, double along, double round, dvec2 corner) {
    constexpr dvec2 size(0.49, 0.16);
    const size_t patch = along < 1 ? 0 : 1;
    const bool back = round > 1;
    const double side = back ? 1 : -1;
    const double t = back ? 2 - round : round;
    std::array<dvec3, 4> sections, slopes;
    for (size_t row = 0; row < 4; ++row) {
        std::array<dvec3, 4> points;
        for (size_t k = 0; k < 4; ++k)
            points[k] = section_point(tube[3 * patch + row], k, side);
        const CurvePoint point = bezier(points, t);
        sections[row] = point.value;
        slopes[row] = back ? -point.slope : point.slope;
    }
    const double s = along - static_cast<double>(patch);
    const CurvePoint at = bezier(sections, s);
    return vertex_of(at.value, at.slope, bezier(slopes, s).value,
                     corner + size * dvec2(along, round) / 2.0);
}

void add_tube(Mesh& mesh, const Tube& tube, dvec2 corner) {
    constexpr int columns = 36, rows = 24;
    add_grid(mesh, columns, rows, [&](int i, int j) {
        return tube_vertex(tube, 2.0 * i / columns, 2.0 * j / rows, corner);
    });
}

}  // namespace

Mesh make_teapot() {
    Mesh mesh;
    for (const Band& band : bands)
        add_band(mesh, band);
    add_tube(mesh, handle, {0, 0.84});
    add_tube(mesh, spout, {0.51, 0.84});
    const glm::vec3 center = bounds_of(mesh).center();
    for (glm::vec3& position : mesh.positions)
        position -= center;
    return mesh;
}

}  // namespace wrinkle
