// One texture at the places of a tile, in float: the same numbers as Texture::sample_lod<float>()
// of every lane by itself.
#pragma once

#include "cpu/kernels.h"
#include "cpu/texture.h"

namespace wrinkle {

// The first `channels` channels at n places, n <= tile_lanes, into out[channel]; more of the four
// may be written. `lod` is not read where the texture has one level.
void sample_tile(const Texture& texture, const Kernels& kernels, size_t channels, const float* u,
                 const float* v, const float* lod, float* const* out, size_t n);

}  // namespace wrinkle
