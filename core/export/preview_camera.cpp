#include "export/preview_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace wrinkle {

PreviewCamera preview_camera(const Mesh& mesh) {
    const glm::dvec3 center(bounds_of(mesh).center());
    double radius = 0;
    for (const uint32_t index : mesh.indices)
        radius = std::max(radius, glm::distance(glm::dvec3(mesh.positions[index]), center));
    constexpr double margin = 1.12, yaw = 0.35, pitch = 0.3;
    const double distance = margin * std::max(radius, 1e-6) / std::sin(preview_field_of_view / 2);
    PreviewCamera camera;
    camera.back = {std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                   std::cos(yaw) * std::cos(pitch)};
    camera.right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), camera.back));
    camera.up = glm::cross(camera.back, camera.right);
    camera.eye = center + distance * camera.back;
    return camera;
}

}  // namespace wrinkle
