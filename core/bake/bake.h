// A program on the texels of a mesh's uv layout: rows of lanes, from the top of the picture down.
//
// Work goes in rows of tiles, so memory is bounded by the mesh, the textures and one row of tiles
// with the margin that dilation looks into. Threads share a row of tiles; how many there are, and
// which rows are asked for, changes no bit.
//
// An edge texel is the mean over its covered samples (mesh/uv_raster.h), its unit vectors made unit
// again. Then every texel that is not covered takes the lanes of the nearest one that is, as long
// as that is at most `dilate` texels away, corner to corner by Pythagoras; of equally near ones the
// one of the nearest column, left before right, above before below.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cpu/evaluate.h"
#include "mesh/uv_raster.h"

namespace wrinkle {

inline constexpr uint32_t bake_tile = 64;  // texels, both ways
inline constexpr uint32_t most_dilation = 1024;

struct BakeInput {
    const Mesh* mesh = nullptr;  // has uv0 and what the program reads
    const Program* program = nullptr;
    std::span<const Texture> textures;  // by resource index
    std::span<const uint32_t> unit;     // first lanes of unit vectors
    uint32_t dilate = 16;               // texels, up to most_dilation
};

struct BakeFindings {
    uint64_t covered = 0;     // texels that hold a surface
    uint64_t not_finite = 0;  // of them, with a number that is not finite
    uint64_t overlapped = 0;  // with more than one triangle at their centre
    // One of these, as a place in texels, and a triangle that owns nothing there.
    uint32_t overlap_x = 0, overlap_y = 0;
    uint32_t overlap_triangle = Coverage::none;

    void add(const BakeFindings& below);
};

// Rows as they come, whole rows of tiles, and whether there is something to see.
struct BakedRows {
    uint32_t first = 0;  // from the top
    uint32_t count = 0;
    const float* values = nullptr;     // row by row: those of lane 0, those of lane 1, ...
    const uint8_t* covered = nullptr;  // a byte a texel: 1 surface, 2 dilated, 0 neither
    BakeFindings found;                // in these
};
// False stops the bake.
using TakeRows = std::function<bool(const BakedRows&)>;

// Rows `first` to `last`, without `last`, both multiples of bake_tile or the end; false when it was
// stopped. Rows are taken one band after the other, while the next is worked on. With `threads` 0
// one for each core.
bool bake_rows(const BakeInput& input, const UvRaster& raster, uint32_t first, uint32_t last,
               uint32_t threads, const TakeRows& take);

}  // namespace wrinkle
