// Rasterises the triangles of a mesh in uv: finds the triangle that owns each texel of a layout.
//
// A layout is width * height texels over one unit square of uv set 0, from the integers `corner` to
// corner + 1; texel (x, y) has its centre at corner + ((x + 1/2) / width, (y + 1/2) / height), v
// upward. Corners of triangles are rounded to 1/256 of a texel, as on GPUs; the arithmetic after
// that is exact: exactly one of two triangles that share an edge owns a point on it. A point on an
// edge belongs to the triangle to its right, or above it for a horizontal edge. If triangles
// overlap, the first one in the mesh owns. Mirrored triangles are treated alike.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/uv_overlap.h"

namespace wrinkle {

struct UvLayout {
    uint32_t width = 1024;  // texels, 1 to 65536
    uint32_t height = 1024;
    glm::ivec2 corner{0};  // lower left of the unit square (mesh/uv_survey.h)
    uint32_t samples = 1;  // per edge texel: 1, 4, 16 or 64

    // Returns the uv of a position in texels.
    glm::dvec2 uv(double x, double y) const {
        return {corner.x + x / width, corner.y + y / height};
    }
};

struct TexelRect {
    uint32_t x = 0, y = 0, width = 0, height = 0;
};

// A sample of an edge texel.
struct UvSample {
    uint32_t triangle;
    glm::dvec2 position;  // in texels of the layout
};

// Coverage of one rectangle of texels. Reuse it to avoid allocations.
struct Coverage {
    static constexpr uint32_t none = ~0U;
    struct EdgeTexel {
        uint32_t texel;         // index in `owners`
        uint32_t first, count;  // range in `samples`
    };

    std::vector<uint32_t> owners;  // per texel, rows upwards; `none` for an edge texel
    size_t owned = 0;              // number of owners other than `none`
    std::vector<EdgeTexel> edges;  // sorted by texel
    std::vector<UvSample> samples;
    uint32_t overlapped = 0;     // texels with centres covered by more than one triangle
    uint32_t overlap_texel = 0;  // the first of them, and a triangle that does not own it
    uint32_t overlap_triangle = none;

    std::vector<uint32_t> slots, sub_owners, candidates;  // scratch
    OpenTexels open;
};

// A range of rows or columns, inclusive.
struct TexelRange {
    int64_t low = 0, high = -1;

    bool empty() const { return low > high; }
    // Returns the part within [first, first + count).
    TexelRange within(uint32_t first, uint32_t count) const {
        return {std::max<int64_t>(low, first), std::min<int64_t>(high, int64_t{first} + count - 1)};
    }
};

// A triangle that may cover texels of the given rows, and its columns.
struct RowCandidate {
    uint32_t triangle;
    TexelRange columns;
};

// The triangle that covers its centre owns a texel. If `samples` is greater than 1, a texel crossed
// by the border of an island is sampled on a grid of that many points instead: it is the mean of
// the covered ones. Borders are edges without a triangle on their other side in uv. So islands
// thinner than a texel are sampled, and islands that end within a texel contribute to it.
//
// Triangles without uv area, or more than 2^21 texels away, own nothing.
class UvRaster {
public:
    // Precondition: the mesh has uv0. The mesh is only read by the constructor.
    UvRaster(const Mesh& mesh, const UvLayout& layout);

    const UvLayout& layout() const { return layout_; }

    // Returns the triangles that may cover texels of rows [y, y + height), in mesh order.
    std::vector<RowCandidate> in_rows(uint32_t y, uint32_t height) const;

    // `candidates` are the result of in_rows() for at least these rows.
    void cover(const TexelRect& rect, std::span<const RowCandidate> candidates,
               Coverage& out) const;

private:
    // Counter-clockwise, in 1/256 texel.
    struct Triangle {
        int32_t x[3] = {}, y[3] = {};
        TexelRange columns;   // columns it touches; empty without area, as rows_
        uint8_t borders = 0;  // bit k: the edge from corner k is an island border
    };

    void add(const Mesh& mesh, size_t index);
    void drop_repeats();
    void find_borders();
    // Calls take(first, last) for each row's span of covered texel centres, as indices in `owners`.
    template <class Take>
    void each_span(const TexelRect& rect, uint32_t index, Take take) const;
    void own_centres(const TexelRect& rect, Coverage& out) const;
    void mark_borders(const TexelRect& rect, uint32_t index, Coverage& out) const;
    void own_samples(const TexelRect& rect, uint32_t index, Coverage& out) const;
    void gather_edges(const TexelRect& rect, Coverage& out) const;

    UvLayout layout_;
    uint32_t across_ = 1;  // samples per axis of a texel
    std::vector<Triangle> triangles_;
    std::vector<TexelRange> rows_;  // rows that each triangle touches
};

}  // namespace wrinkle
