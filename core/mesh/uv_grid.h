// Which triangles of a mesh may cover a uv: a grid of squares over its layout, made once where many
// places are looked up.
//
// Linear time and memory in the triangles; a place is answered in the triangles of its square, a
// few of them unless many lie over each other.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace wrinkle {

// A triangle may cover places this much outside of its box, as a share of the box's sides.
inline constexpr double uv_box_margin = 1e-5;

class UvGrid {
public:
    explicit UvGrid(const Mesh& mesh);  // has uv0

    // All that cover the uv, in the mesh's order, and some beside it.
    std::span<const uint32_t> near(glm::dvec2 uv) const;

private:
    struct Cells {
        uint32_t low[2], high[2];  // both included
        uint64_t count() const { return uint64_t{high[0] - low[0] + 1} * (high[1] - low[1] + 1); }
    };
    uint32_t cell_of(double place, int axis) const;
    Cells cells_of(const Mesh& mesh, size_t triangle) const;
    void choose_side(const Mesh& mesh);

    glm::dvec2 low_{0}, high_{0};     // of the layout
    uint32_t side_ = 1;               // squares, both ways
    std::vector<uint32_t> covering_;  // triangles with an area, in the mesh's order
    std::vector<uint32_t> first_;     // of each square, in triangles_; one more at the end
    std::vector<uint32_t> triangles_;
};

}  // namespace wrinkle
