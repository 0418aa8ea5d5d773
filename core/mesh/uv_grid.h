// A uniform grid over a uv layout that returns the triangles that may cover a uv.
//
// Build time and memory are linear in the triangles. A lookup returns the triangles of one cell: a
// few, unless many overlap.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

// Bounding box of a triangle in uv, enlarged by 1e-5 of its size for rounding errors: the triangle
// covers no uv outside of it.
struct UvBox {
    glm::dvec2 low{0}, high{0};

    bool contains(glm::dvec2 uv) const {
        return uv.x >= low.x && uv.y >= low.y && uv.x <= high.x && uv.y <= high.y;
    }
};
UvBox uv_box(const Mesh& mesh, size_t triangle);  // precondition: the mesh has uv0

class UvGrid {
public:
    explicit UvGrid(const Mesh& mesh);  // precondition: the mesh has uv0

    // Returns all triangles that cover the uv, in mesh order, and some near it.
    std::span<const uint32_t> near(glm::dvec2 uv) const;

private:
    struct CellRange {
        uint32_t low[2], high[2];  // inclusive
        uint64_t count() const { return uint64_t{high[0] - low[0] + 1} * (high[1] - low[1] + 1); }
    };
    uint32_t cell_of(double coordinate, int axis) const;
    CellRange cells_of(const Mesh& mesh, size_t triangle) const;
    void choose_side(const Mesh& mesh);

    UvBox box_;                                 // bounds of the layout
    uint32_t side_ = 1;                         // cells per axis
    std::vector<uint32_t> covering_;            // triangles with an area, in the mesh's order
    std::vector<std::vector<uint32_t>> cells_;  // triangles per cell
};

}  // namespace wrinkle
