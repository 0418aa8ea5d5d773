// A texture as GL samples it: mips, bilinear filtering, wrap modes.
//
// Texel (x, y) of a level has its centre at ((x + 1/2) / width, (y + 1/2) / height), v upward. The
// lod is clamped to the levels there are; between two levels results mix linearly. With the filter
// `nearest` the nearest texel of the nearest level is taken. NaN and infinite coordinates read as
// 0. Missing channels follow expand_texel() of image/image.h.
//
// The texels are the mip chain's own, shared and never copied, as many channels as it has.
#pragma once

#include <array>
#include <memory>

#include "base/texture_options.h"
#include "image/mips.h"

namespace wrinkle {

class Texture {
public:
    Texture() = default;  // one black texel
    Texture(std::shared_ptr<const MipChain> chain, const TextureOptions& options);
    Texture(MipChain chain, const TextureOptions& options);

    uint32_t width() const { return chain_->levels[0].width; }
    uint32_t height() const { return chain_->levels[0].height; }

    // r, g, b, a. The weights are computed in T.
    template <class T>
    std::array<T, 4> sample_lod(T u, T v, T lod) const;

private:
    template <class T>
    std::array<T, 4> bilinear(const Image& level, T u, T v) const;
    template <class T, uint32_t channels>
    std::array<T, 4> bilinear_of(const Image& level, T u, T v) const;
    template <class T>
    std::array<T, 4> nearest(const Image& level, T u, T v) const;

    std::shared_ptr<const MipChain> chain_ = black();
    TextureOptions options_;

    static std::shared_ptr<const MipChain> black();
};

}  // namespace wrinkle
