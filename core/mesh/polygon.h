// Triangulates polygons with any number of corners.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace wrinkle {

// Appends three of `corners` per triangle, n - 2 triangles, with the orientation of the polygon.
// positions[i] belongs to corners[i]. Convex polygons, and concave ones of more than 256 corners,
// become a fan of the first corner; others are ear-clipped in the plane of their mean normal.
// Polygons that cross themselves or have no area also yield n - 2 triangles.
void append_triangles(std::span<const glm::vec3> positions, std::span<const uint32_t> corners,
                      std::vector<uint32_t>& indices);

}  // namespace wrinkle
