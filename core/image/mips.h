// Mip levels of an image, by one filter for all backends.
//
// Level k + 1 has size max(1, floor(n / 2)) in each direction, as in GL, down to 1 x 1. Each of its
// texels is the area-weighted mean of the texels it covers: two per direction for even sizes, three
// with the weights (m - i, m, i + 1) / n for odd n = 2m + 1 (the polyphase box filter of Guthe and
// Heckbert, "Non-Power-of-Two Mipmap Creation", NVIDIA 2005). The mean of an image is preserved; a
// constant image is preserved bit for bit. Sums are in double, bottom to top and left to right.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace wrinkle {

struct MipChain {
    std::vector<Image> levels;  // [0] is the image itself; empty for an empty image

    uint32_t count() const { return static_cast<uint32_t>(levels.size()); }
};

uint32_t next_mip_size(uint32_t size);                // one direction
uint32_t mip_count(uint32_t width, uint32_t height);  // 1 + floor(log2(max)); 0 for no texels

// Returns the next level. The filter works on raw values, without wrapping and without
// renormalising: the mean of unit normals is shorter than one, and that length is information. NaN
// propagates to every texel that covers it.
Image half_size(const Image& image);

// Filters one row of the next level, for images that are not completely in memory. half_row()
// computes row y of the next level of a width x height image with any number of channels from the
// rows of covered_rows(height, y).
struct CoveredRows {
    uint32_t first = 0;
    uint32_t count = 0;  // 1 to 3
};
CoveredRows covered_rows(uint32_t height, uint32_t y);
void half_row(uint32_t width, uint32_t height, uint32_t channels, uint32_t y,
              const float* const* rows, float* out);
MipChain build_mips(Image base);

}  // namespace wrinkle
