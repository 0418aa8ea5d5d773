#include "mesh/uv_triangle.h"

#include <cmath>

namespace wrinkle {

namespace {

struct UvSides {
    glm::dvec2 first, a, b;  // corner 0, and the vectors from it to corners 1 and 2

    double determinant() const { return a.x * b.y - b.x * a.y; }
    bool have_area() const { return determinant() != 0 && std::isfinite(determinant()); }
};

UvSides sides_of(const Mesh& mesh, size_t triangle) {
    const auto corner = [&](size_t k) {
        return glm::dvec2(mesh.uvs[0][mesh.indices[3 * triangle + k]]);
    };
    const glm::dvec2 first = corner(0);
    return {first, corner(1) - first, corner(2) - first};
}

}  // namespace

bool has_uv_area(const Mesh& mesh, size_t triangle) {
    return sides_of(mesh, triangle).have_area();
}

std::optional<UvTriangle> uv_triangle(const Mesh& mesh, size_t triangle) {
    const UvSides sides = sides_of(mesh, triangle);
    if (!sides.have_area()) return std::nullopt;
    const double determinant = sides.determinant();
    return UvTriangle{sides.first, glm::dvec2(sides.b.y, -sides.b.x) / determinant,
                      glm::dvec2(-sides.a.y, sides.a.x) / determinant};
}

}  // namespace wrinkle
