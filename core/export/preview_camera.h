// The camera of exported scenes: it looks at the mesh from above and from the right, as the one of
// `wrinkle render` looks at a sphere.
#pragma once

#include <glm/vec3.hpp>

#include "mesh/mesh.h"

namespace wrinkle {

inline constexpr double preview_field_of_view = 0.5;  // radians, of a square image

// Axes of the camera, y up: it looks along -back.
struct PreviewCamera {
    glm::dvec3 right{0}, up{0}, back{0}, eye{0};
};
PreviewCamera preview_camera(const Mesh& mesh);

}  // namespace wrinkle
