// The surface point of a mesh at a uv of set 0.
//
// Attributes are interpolated over the triangle that covers the uv, as in a rasteriser, without
// normalisation. dx and dy are differentials of each attribute over one texel of a size * size
// layout of uv0 (du = 1 / size for dx, dv = 1 / size for dy) in the plane of that triangle. uv0 is
// the given uv, with dx exactly (1 / size, 0) and dy (0, 1 / size). Attributes that the mesh lacks
// are zero.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "mesh/mesh.h"

namespace wrinkle {

struct SurfaceAttributes {
    glm::dvec3 position{0};
    glm::dvec3 normal{0};
    glm::dvec4 tangent{0};  // w is the handedness, constant over a triangle
    std::array<glm::dvec2, max_uv_sets> uv{};
    glm::dvec4 color{0};
};

struct SurfacePoint {
    SurfaceAttributes value;
    SurfaceAttributes dx;
    SurfaceAttributes dy;
    uint32_t triangle = 0;
};

// Returns the point of the first of the triangles that covers the uv, if several do (overlap,
// shared edge). The uv is not wrapped. Returns std::nullopt if no triangle with uv area covers the
// uv. `triangles` are those of UvGrid::near(). Preconditions: the mesh has uv0, size >= 1.
std::optional<SurfacePoint> sample_mesh(const Mesh& mesh, std::span<const uint32_t> triangles,
                                        glm::dvec2 uv, uint32_t size);

}  // namespace wrinkle
