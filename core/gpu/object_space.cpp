#include "gpu/object_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace wrinkle::gpu {
namespace {

// Scaled so that the largest entry is 1: normals are normalised later, and their squares must not
// underflow.
glm::mat3 normal_matrix(const glm::dmat3& m) {
    const glm::dmat3 result(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            largest = std::max(largest, std::abs(result[i][k]));
    return glm::mat3(result * ((glm::determinant(m) < 0 ? -1 : 1) / largest));
}

std::array<glm::vec3, 8> corners_of(const Bounds& bounds, const glm::mat4& object) {
    std::array<glm::vec3, 8> corners;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::vec3 corner(i & 1 ? bounds.low.x : bounds.high.x,
                               i & 2 ? bounds.low.y : bounds.high.y,
                               i & 4 ? bounds.low.z : bounds.high.z);
        corners[i] = glm::vec3(object * glm::vec4(corner, 1));
    }
    return corners;
}

}  // namespace

std::optional<ObjectSpace> object_space(const glm::mat4& object, const OrbitCamera& camera,
                                        const Bounds& bounds, float aspect) {
    const glm::dmat4 precise(object);
    const double determinant = glm::determinant(glm::dmat3(precise));
    if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
    ObjectSpace space;
    const std::array<glm::vec3, 8> corners = corners_of(bounds, object);
    space.in_world = {corners[0], corners[0]};
    float reach = 0;
    for (const glm::vec3 corner : corners) {
        reach = std::max(reach, glm::distance(corner, camera.target));
        space.in_world = {glm::min(space.in_world.low, corner),
                          glm::max(space.in_world.high, corner)};
    }
    // In double, so that large translations cancel before the conversion to float.
    space.to_clip =
        projection_matrix(camera, aspect, reach) * glm::mat4(view_matrix(camera) * precise);
    space.vector_to_world = glm::mat3(object);
    space.normal_to_world = normal_matrix(glm::dmat3(precise));
    space.eye = glm::vec3(glm::inverse(precise) * glm::dvec4(eye_of(camera), 1));
    space.mirrored = determinant < 0;
    return space;
}

}  // namespace wrinkle::gpu
