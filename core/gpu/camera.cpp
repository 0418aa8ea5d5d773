#include "gpu/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace wrinkle::gpu {
namespace {

struct Framing {
    std::string_view shape;
    float yaw;
    float pitch;
    float radius;  // bounding sphere that the image must contain
};

// The plane is viewed head-on, so its radius is half of its side.
constexpr std::array<Framing, 6> framings{{{"sphere", 0.35F, 0.3F, 1.0F},
                                           {"plane", 0, 0, 1.0F},
                                           {"cube", 0.6F, 0.45F, 1.55F},
                                           {"cylinder", 0.35F, 0.4F, 1.35F},
                                           {"torus", 0.35F, 0.8F, 0.95F},
                                           {"teapot", 0.35F, 0.4F, 1.35F}}};
constexpr float margin = 1.12F;

Framing framing_of(const Mesh& mesh, std::string_view shape) {
    for (const Framing& framing : framings)
        if (framing.shape == shape) return framing;
    const glm::vec3 center = bounds_of(mesh).center();
    float radius = 0;
    for (const uint32_t index : mesh.indices)
        radius = std::max(radius, glm::distance(mesh.positions[index], center));
    return {"", 0.5F, 0.35F, radius};
}

}  // namespace

glm::dvec3 eye_of(const OrbitCamera& camera) {
    const double limit = glm::radians(89.0), yaw = camera.yaw;
    const double pitch = std::clamp<double>(camera.pitch, -limit, limit);
    const glm::dvec3 backwards(std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                               std::cos(yaw) * std::cos(pitch));
    return glm::dvec3(camera.target) + static_cast<double>(camera.distance) * backwards;
}

glm::dmat4 view_matrix(const OrbitCamera& camera) {
    return glm::lookAt(eye_of(camera), glm::dvec3(camera.target), glm::dvec3(0, 1, 0));
}

glm::mat4 projection_matrix(const OrbitCamera& camera, float aspect, float radius) {
    const float half = std::tan(camera.field_of_view / 2);
    const float vertical = 2 * std::atan(aspect < 1 ? half / aspect : half);
    const float far = (camera.distance + radius) * 1.01F;
    const float near = std::max(camera.distance - radius, camera.distance * 0.01F) * 0.99F;
    return glm::perspective(vertical, aspect, near, far);
}

Rays rays_of(const OrbitCamera& camera, float aspect) {
    // Rows of the view matrix: the camera's axes in the world.
    const glm::dmat4 view = view_matrix(camera);
    const auto axis = [&](int row) { return glm::vec3(view[0][row], view[1][row], view[2][row]); };
    const float half = std::tan(camera.field_of_view / 2);
    return {-axis(2), axis(0) * half * std::max(aspect, 1.0F),
            axis(1) * half / std::min(aspect, 1.0F)};
}

OrbitCamera default_camera(const Mesh& mesh, std::string_view shape) {
    const Framing framing = framing_of(mesh, shape);
    OrbitCamera camera;
    camera.target = bounds_of(mesh).center();
    camera.yaw = framing.yaw;
    camera.pitch = framing.pitch;
    const float radius = framing.radius > 0 ? framing.radius : 1;
    const float half = camera.field_of_view / 2;
    const bool flat = framing.shape == "plane";
    camera.distance = margin * radius / (flat ? std::tan(half) : std::sin(half));
    return camera;
}

}  // namespace wrinkle::gpu
