// A texture with the sampling rules of GL: mips, bilinear filtering, wrap modes.
//
// Texel (x, y) of a level has its centre at ((x + 1/2) / width, (y + 1/2) / height), v up. The lod
// is clamped to the existing levels; results of two levels are interpolated linearly. The filter
// `nearest` takes the nearest texel of the nearest level. NaN and infinite coordinates are treated
// as 0. Missing channels follow expand_texel() of image/image.h.
//
// The mip chain is shared and never copied; tiles sample it in the layout of packed_mip_chain.h.
#pragma once

#include <array>
#include <memory>

#include "base/texture_options.h"
#include "cpu/packed_mip_chain.h"
#include "image/mips.h"

namespace wrinkle {

class Texture {
public:
    Texture() = default;  // one black texel
    Texture(std::shared_ptr<const PackedMipChain> texels,
            const TextureOptions& options);  // null: black
    Texture(MipChain chain, const TextureOptions& options);

    uint32_t width() const { return levels()[0].width; }
    uint32_t height() const { return levels()[0].height; }
    uint32_t level_count() const { return static_cast<uint32_t>(levels().size()); }
    const PackedMipChain& texels() const { return *texels_; }
    const TextureOptions& options() const { return options_; }

    // Returns r, g, b, a. The weights are computed in T.
    template <class T>
    std::array<T, 4> sample_lod(T u, T v, T lod) const;

private:
    const std::vector<Image>& levels() const { return texels_->chain()->levels; }

    std::shared_ptr<const PackedMipChain> texels_ = black();
    TextureOptions options_;

    static std::shared_ptr<const PackedMipChain> black();
};

}  // namespace wrinkle
