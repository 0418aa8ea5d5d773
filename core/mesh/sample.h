// The surface point of a mesh at a uv of its set 0.
//
// Attributes are interpolated over the triangle that covers the uv, as a rasteriser does: nothing
// is normalised. dx and dy are the change of each attribute over one texel of a size * size layout
// of uv0: du = 1 / size for dx, dv = 1 / size for dy, within the plane of that triangle. uv0 is not
// interpolated: it is the uv itself, its dx exactly (1 / size, 0), its dy (0, 1 / size). Attributes
// that the mesh lacks are absent in `has` and zero.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "base/diagnostics.h"
#include "mesh/mesh.h"
#include "mesh/uv_grid.h"

namespace wrinkle {

struct SurfaceAttributes {
    glm::dvec3 position{0};
    glm::dvec3 normal{0};
    glm::dvec4 tangent{0};  // w is the handedness, constant over a triangle
    std::array<glm::dvec2, max_uv_sets> uv{};
    glm::dvec4 color{0};
};

struct AttributePresence {
    bool normal = false;
    bool tangent = false;
    std::array<bool, max_uv_sets> uv{};
    bool color = false;
};

struct SurfacePoint {
    SurfaceAttributes value;
    SurfaceAttributes dx;
    SurfaceAttributes dy;
    AttributePresence has;
    uint32_t triangle = 0;
};

// Several triangles may cover the uv (they overlap, or it lies on an edge): the first one counts.
// The uv is not wrapped. Errors: no uv0, size 0, no triangle with area in uv covers it.
std::optional<SurfacePoint> sample_mesh(const Mesh& mesh, glm::dvec2 uv, uint32_t size,
                                        Diagnostics& diagnostics);

// The same of one place after the other, by a grid of the mesh: nothing where no triangle covers
// the uv. The mesh has uv0, the size is at least 1.
std::optional<SurfacePoint> sample_mesh(const Mesh& mesh, const UvGrid& grid, glm::dvec2 uv,
                                        uint32_t size);

}  // namespace wrinkle
