// Orbit camera. World space is right-handed, +y up; with yaw 0 and pitch 0 the view direction is
// -z. Angles in radians, lengths in world units.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "mesh/mesh.h"

namespace wrinkle::gpu {

struct OrbitCamera {
    glm::vec3 target{0};
    float yaw = 0;               // positive moves the eye to the right
    float pitch = 0;             // positive moves the eye up; clamped to +-89 degrees
    float distance = 4;          // from the eye to the target
    float field_of_view = 0.5F;  // along the shorter side of the image
};

// In double: far from the origin the spacing of floats exceeds the size of the viewed object.
glm::dvec3 eye_of(const OrbitCamera& camera);
glm::dmat4 view_matrix(const OrbitCamera& camera);
// `radius` is the radius of a sphere around the target that contains the scene; it sets the depth
// range.
glm::mat4 projection_matrix(const OrbitCamera& camera, float aspect, float radius);

// The ray through the point (x, y) of the image, each from -1 to 1, has the direction
// forward + x right + y up, in world space.
struct Rays {
    glm::vec3 forward, right, up;
};
Rays rays_of(const OrbitCamera& camera, float aspect);

// Returns a camera that frames the complete mesh, slightly from above; a plane is viewed head-on.
// `shape` is a name of mesh/shapes.h; any other mesh is framed by its bounds.
OrbitCamera default_camera(const Mesh& mesh, std::string_view shape = {});

}  // namespace wrinkle::gpu
