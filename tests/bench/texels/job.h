// The job of the texel benchmark: two RGBA8 normal maps of 2048 x 2048, bilinear and repeated, the
// second tiled four times at a sub-texel offset; decode, add the surface gradients on an
// interpolated frame, resolve, write RGBA8 of 2048 x 2048.
//
// Every contestant starts from the same textures and frames and ends with packed texels, row 0 at
// the bottom. Megatexels per second are compared, never times of different runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/mips.h"

namespace wrinkle::bench {

inline constexpr uint32_t side = 2048;
inline constexpr size_t texel_count = size_t{side} * side;
inline constexpr float tiling = 4, offset_u = 0.3F / side, offset_v = 0.7F / side, amount = 0.5F;

// A surface value: at + across * x + up * y, x and y in texels from the centre of the first texel.
struct Affine {
    float at = 0, across = 0, up = 0;

    float operator()(float x, float y) const { return at + across * x + up * y; }
};

// Interpolated attributes: N and T (not normalised), w, uv.
struct Frame {
    Affine normal[3], tangent[3], uv[2];
};
const Frame& frame();
inline constexpr float tangent_w = 1;

struct Textures {
    MipChain base, detail;  // floats; one level each, so that only bilinear filtering is used
    std::vector<uint32_t> rgba_base;  // the same texels, r in the lowest byte
    std::vector<uint32_t> rgba_detail;
};
const Textures& textures();

std::string graph_text();  // a graph of graphs/; textures() replaces its images

using Packed = std::vector<uint32_t>;

// Throughput in megatexels per second: by wall time, and by the processor time of each thread.
struct Rate {
    double wall = 0, processor = 0;
};

}  // namespace wrinkle::bench
