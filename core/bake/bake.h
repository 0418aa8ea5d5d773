// Bakes a program over a mesh's uv layout; results are rows of lanes, from the top of the image
// down. Rows of tiles are computed one after the other, so memory is bounded by the mesh, the
// textures and one row of tiles with the margin that dilation reads. Threads share a row of tiles.
// The results do not depend on the number of threads or on the requested row range, bit by bit.
//
// An edge texel is the mean over its covered samples (mesh/uv_raster.h), with unit vectors
// normalised again.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cpu/evaluate.h"
#include "mesh/uv_raster.h"

namespace wrinkle {

inline constexpr uint32_t bake_tile = 64;  // per side
inline constexpr uint32_t max_dilation = 1024;

struct BakeInput {
    const Mesh* mesh = nullptr;  // with uv0 and the attributes that the program reads
    const Program* program = nullptr;
    std::span<const Texture> textures;  // by resource index
    std::span<const uint32_t> unit;     // first lanes of unit vectors in the output
    // A texel that is not covered takes the lanes of the nearest covered one within this Euclidean
    // distance in texels. Ties: nearest column first, left before right, above before below.
    uint32_t dilate = 16;  // up to max_dilation
};

struct BakeStatistics {
    uint64_t covered = 0;      // texels with a surface
    uint64_t not_finite = 0;   // covered texels with a non-finite number
    uint64_t overlapped = 0;   // texels with several triangles at their centre
    glm::dvec2 overlap_uv{0};  // centre of one of these, and a triangle hidden there
    uint32_t overlap_triangle = 0;

    void add(const BakeStatistics& below);
};

// A band of finished rows: complete rows of tiles, with their coverage.
struct BakedRows {
    uint32_t first = 0;  // from the top
    uint32_t count = 0;
    const float* values = nullptr;     // per row: one plane of width floats per lane
    const uint8_t* covered = nullptr;  // one byte per texel: 1 surface, 2 dilated, 0 neither
    BakeStatistics found;              // in these rows
};
// Return false to cancel the bake.
using RowSink = std::function<bool(const BakedRows&)>;

// Bakes rows [first, last), both multiples of bake_tile or the layout's height. Returns false if
// `take` cancelled. `take` receives one band after the other, while the next one is computed.
// `threads` 0: one per core.
bool bake_rows(const BakeInput& input, const UvRaster& raster, uint32_t first, uint32_t last,
               uint32_t threads, const RowSink& take);

}  // namespace wrinkle
