// What an object matrix M means for the points, vectors and normals of a drawn object.
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
    glm::mat3 normal_to_world;  // cof(M) times the sign of det(M), so that outside stays outside;
                                // up to a positive factor
    glm::vec3 eye;              // in object space
    bool mirrored;              // det(M) < 0: triangles turn their winding
};

// Nothing when M has no inverse. `bounds` are the object's own, for the depth range.
std::optional<ObjectSpace> object_space(const glm::mat4& object, const OrbitCamera& camera,
                                        const Bounds& bounds, float aspect);

}  // namespace wrinkle::gpu
