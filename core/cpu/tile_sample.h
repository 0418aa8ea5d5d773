// One texture at the places of a tile, in float: the same numbers as Texture::sample_lod<float>()
// of every lane by itself.
#pragma once

#include <array>

#include "cpu/kernels.h"
#include "cpu/texture.h"

namespace wrinkle {

struct TileSample {
    size_t channels = 4;  // more may be written
    float bias = 0;       // taken off every channel
    const float* u = nullptr;
    const float* v = nullptr;
    const float* lod = nullptr;  // not read where the texture has one level
    std::array<float*, 4> out{};
    size_t count = 0;  // at most tile_lanes
};
void sample_tile(const Texture& texture, const Kernels& kernels, const TileSample& sample);

}  // namespace wrinkle
