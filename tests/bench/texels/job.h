// The job that evaluators of texels are measured by: two RGBA8 normal maps of 2048 x 2048, bilinear
// and repeated, the second tiled four times at an offset that falls between texels; decoded, their
// surface gradients added on an interpolated frame, resolved; written as RGBA8 of 2048 x 2048.
//
// Whoever does it starts from the same textures and frames and ends with packed texels, row 0 at
// the bottom. Mega-texels a second are what is compared, never times of different runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/mips.h"

namespace wrinkle::bench {

inline constexpr uint32_t side = 2048;
inline constexpr size_t texel_count = size_t{side} * side;
inline constexpr float tiling = 4, offset_u = 0.3F / side, offset_v = 0.7F / side, amount = 0.5F;

// A surface value: at + across * x + up * y, x and y in texels from the first one's middle.
struct Affine {
    float at = 0, across = 0, up = 0;

    float operator()(float x, float y) const { return at + across * x + up * y; }
};

// What is interpolated: N and T of no particular length, w, uv.
struct Frame {
    Affine normal[3], tangent[3], uv[2];
};
const Frame& frame();
inline constexpr float tangent_w = 1;

struct Textures {
    MipChain base, detail;  // floats; one level each, so that nothing but bilinear is asked
    std::vector<uint32_t> rgba_base;  // the same, r in the lowest byte
    std::vector<uint32_t> rgba_detail;
};
const Textures& textures();

std::string graph_text();  // in graphs/; our texels stand for the images that it names

using Packed = std::vector<uint32_t>;

// Packed a second in millions, by the wall's clock and by what each thread of the process used.
struct Rate {
    double wall = 0, processor = 0;
};

}  // namespace wrinkle::bench
