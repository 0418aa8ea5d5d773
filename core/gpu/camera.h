// A camera that circles a point and looks at it. World space: right-handed, +y up; yaw 0 and pitch
// 0 look along -z. Angles in radians, lengths in world units.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "mesh/mesh.h"

namespace wrinkle::gpu {

struct OrbitCamera {
    glm::vec3 target{0};
    float yaw = 0;               // positive moves the eye to the right
    float pitch = 0;             // positive moves the eye up; kept within +-89 degrees
    float distance = 4;          // of the eye from the target
    float field_of_view = 0.5F;  // of the shorter side of the picture
};

// In double: far from the origin a float's steps are larger than what is looked at.
glm::dvec3 eye_of(const OrbitCamera& camera);
glm::dmat4 view_matrix(const OrbitCamera& camera);
// `radius` is that of a ball round the target with all there is to see; it sets the depth range.
glm::mat4 projection_matrix(const OrbitCamera& camera, float aspect, float radius);

// Sees all of the mesh, a little from above; flat shapes are looked at straight. `shape` is a name
// of mesh/shapes.h, anything else is framed by its bounds.
OrbitCamera default_camera(const Mesh& mesh, std::string_view shape = {});

}  // namespace wrinkle::gpu
