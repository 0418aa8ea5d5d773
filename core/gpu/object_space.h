// Transforms of the points, vectors and normals of a drawn object, derived from its matrix M.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

#include "gpu/camera.h"
#include "mesh/mesh.h"

namespace wrinkle::gpu {

struct ObjectSpace {
    glm::mat4 to_clip;
    glm::mat3 vector_to_world;
    glm::mat3 normal_to_world;  // cof(M) times the sign of det(M), so that outside remains
                                // outside; up to a positive factor
    glm::vec3 eye;              // in object space
    Bounds in_world;            // box around the transformed bounds
    bool mirrored;              // det(M) < 0: the winding of triangles is reversed
};

// Returns std::nullopt if M is singular. `bounds` are in object space and set the depth range.
std::optional<ObjectSpace> object_space(const glm::mat4& object, const OrbitCamera& camera,
                                        const Bounds& bounds, float aspect);

}  // namespace wrinkle::gpu
