// Samples one texture at the points of a tile, in float. Results are those of
// Texture::sample_lod<float>() for each lane.
#pragma once

#include <array>

#include "cpu/kernels.h"
#include "cpu/texture.h"

namespace wrinkle {

struct TileSample {
    size_t channels = 4;  // more may be written
    float bias = 0;       // subtracted from every channel
    const float* u = nullptr;
    const float* v = nullptr;
    const float* lod = nullptr;  // not read if the texture has one level
    std::array<float*, 4> out{};
    size_t count = 0;  // at most tile_points
};
void sample_tile(const Texture& texture, const Kernels& kernels, const TileSample& sample);

}  // namespace wrinkle
