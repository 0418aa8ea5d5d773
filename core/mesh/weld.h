// Vertices that are one place, and unit vectors of any length: what normals and tangents share.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

// For each vertex the first one with the same position, or with the same position, normal and uv0.
// Values are equal as numbers: -0 is 0, and NaN is equal to nothing.
std::vector<uint32_t> weld_positions(const Mesh& mesh);
std::vector<uint32_t> weld_frames(const Mesh& mesh);  // has normals and uv0

// Zero for a vector that is zero or not finite; no length under- or overflows.
glm::dvec3 unit_or_zero(glm::dvec3 v);

}  // namespace wrinkle
