// Vertex welding and safe normalisation, shared by normals and tangents.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

// Returns, for each vertex, the first one with the same position, or with the same position, normal
// and uv0. Values compare as numbers: -0 equals 0, and NaN equals nothing.
std::vector<uint32_t> weld_positions(const Mesh& mesh);
std::vector<uint32_t> weld_frames(const Mesh& mesh);  // precondition: the mesh has normals and uv0

// Returns the unit vector, or zero if v is zero or not finite. Lengths do not under- or overflow.
glm::dvec3 unit_or_zero(glm::dvec3 v);

}  // namespace wrinkle
