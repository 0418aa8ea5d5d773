// Polygons of any number of corners, cut into triangles.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace wrinkle {

// Appends three of `corners` per triangle, n - 2 triangles, in the polygon's own sense of rotation.
// positions[i] belongs to corners[i]. Convex polygons become a fan of their first corner; others
// lose one ear after the other in the plane of their mean normal. What crosses itself or has no
// area gives triangles all the same; so does a concave polygon of more than 256 corners, as a fan.
void append_triangles(std::span<const glm::vec3> positions, std::span<const uint32_t> corners,
                      std::vector<uint32_t>& indices);

}  // namespace wrinkle
