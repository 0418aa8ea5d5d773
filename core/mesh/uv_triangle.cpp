#include "mesh/uv_triangle.h"

#include <cmath>

namespace wrinkle {

std::optional<UvTriangle> uv_triangle(const Mesh& mesh, size_t triangle) {
    const auto corner = [&](size_t k) {
        return glm::dvec2(mesh.uvs[0][mesh.indices[3 * triangle + k]]);
    };
    const glm::dvec2 first = corner(0);
    const glm::dvec2 a = corner(1) - first;
    const glm::dvec2 b = corner(2) - first;
    const double determinant = a.x * b.y - b.x * a.y;
    if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
    return UvTriangle{first, glm::dvec2(b.y, -b.x) / determinant,
                      glm::dvec2(-a.y, a.x) / determinant};
}

}  // namespace wrinkle
