// Which triangle of a mesh owns which texel of a uv layout.
//
// A layout is width * height texels over one square of uv set 0, from the whole numbers `corner` to
// corner + 1; texel (x, y) has its centre at corner + ((x + 1/2) / width, (y + 1/2) / height), v
// upward. Corners of triangles are rounded to 1/256 of a texel, as GPUs do; from there on the
// arithmetic is exact: of two triangles that share an edge, exactly one owns a place on it. A place
// on an edge belongs to the triangle to its right or, of a level edge, above it. Where triangles
// overlap the first one of the mesh owns. Mirrored triangles are like all others.
//
// A texel is owned by what covers its centre. With `samples` more than 1, a texel that is crossed
// by the border of an island is looked at in that many places instead, a grid: it is a mean over
// those that are covered. Borders are the edges that have no triangle on their other side in uv.
// So an island thinner than a texel is met, and one that ends within a texel colours it.
//
// Triangles without area in uv own nothing, nor do those further than 2^21 texels away.
#pragma once

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
    glm::ivec2 corner{0};  // of the square (mesh/uv_survey.h)
    uint32_t samples = 1;  // of an edge texel: 1, 4, 16 or 64

    // Of a place in texels.
    glm::dvec2 uv(double x, double y) const {
        return {corner.x + x / width, corner.y + y / height};
    }
};

struct TexelRect {
    uint32_t x = 0, y = 0, width = 0, height = 0;
};

// An edge texel's sample.
struct UvSample {
    uint32_t triangle;
    glm::dvec2 place;  // texels of the layout
};

// What one rectangle of texels is covered by; to be used again and again, as it keeps its memory.
struct Coverage {
    static constexpr uint32_t none = ~0U;
    struct EdgeTexel {
        uint32_t texel;         // its place in `owners`
        uint32_t first, count;  // in `samples`
    };

    std::vector<uint32_t> owners;  // of the centres, row by row upwards; `none` of an edge texel
    size_t owned = 0;              // how many of them are not `none`
    std::vector<EdgeTexel> edges;  // in the order of their texels
    std::vector<UvSample> samples;
    uint32_t overlapped = 0;     // texels whose centre more than one triangle covers
    uint32_t overlap_texel = 0;  // the first of them, and the triangle that does not own it
    uint32_t overlap_triangle = none;

    std::vector<uint32_t> slots, sub_owners, met;  // room to work in
    OpenTexels open;
};

// A triangle that rows may meet, and the texels of these that it may meet, both included.
struct RowCandidate {
    uint32_t triangle;
    int32_t low, high;
};

class UvRaster {
public:
    // The mesh has uv0 and stays as it is.
    UvRaster(const Mesh& mesh, const UvLayout& layout);

    const UvLayout& layout() const { return layout_; }

    // The triangles that rows y to y + height may meet, in the mesh's order.
    std::vector<RowCandidate> in_rows(uint32_t y, uint32_t height) const;

    // `candidates` come from in_rows() with at least these rows.
    void cover(const TexelRect& rect, std::span<const RowCandidate> candidates,
               Coverage& out) const;

private:
    struct Texels {
        int32_t low = 0, high = -1;  // both included
    };
    // Counter-clockwise, in 1/256 texel.
    struct Triangle {
        int32_t x[3] = {}, y[3] = {};
        Texels columns;       // that it meets; as rows_: none without an area
        uint8_t borders = 0;  // bit k: the edge from corner k on is a border of its island
    };

    static Texels texels_of(const int32_t (&places)[3]);
    static void find_met(const TexelRect& rect, std::span<const RowCandidate> candidates,
                         Coverage& out);
    void add(const Mesh& mesh, size_t index);
    void drop_repeats();
    void find_group_rows();
    void find_borders();
    // Calls take(texel, count) for the centres in each row that the triangle covers.
    template <class Take>
    void each_span(const TexelRect& rect, uint32_t index, Take take) const;
    void own_centres(const TexelRect& rect, Coverage& out) const;
    void own_in_order(const TexelRect& rect, Coverage& out) const;
    void mark_borders(const TexelRect& rect, uint32_t index, Coverage& out) const;
    void own_samples(const TexelRect& rect, uint32_t index, Coverage& out) const;
    void gather_edges(const TexelRect& rect, Coverage& out) const;

    UvLayout layout_;
    uint32_t across_ = 1;  // samples in a row of a texel
    std::vector<Triangle> triangles_;
    std::vector<Texels> rows_;        // that each of them meets
    std::vector<Texels> group_rows_;  // that each group of them meets
};

}  // namespace wrinkle
