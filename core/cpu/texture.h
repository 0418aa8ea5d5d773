// A texture as GL samples it: mips, bilinear filtering, wrap modes.
//
// Texel (x, y) of a level has its centre at ((x + 1/2) / width, (y + 1/2) / height), v upward. The
// lod is clamped to the levels there are; between two levels results mix linearly. With the filter
// `nearest` the nearest texel of the nearest level is taken. NaN and infinite coordinates read as
// 0. Missing channels follow expand_texel() of image/image.h.
//
// The mip chain is shared and never copied; tiles read it as texels.h arranges it.
#pragma once

#include <array>
#include <memory>

#include "base/texture_options.h"
#include "cpu/texels.h"
#include "image/mips.h"

namespace wrinkle {

class Texture {
public:
    Texture() = default;  // one black texel
    Texture(std::shared_ptr<const Texels> texels, const TextureOptions& options);  // null: black
    Texture(MipChain chain, const TextureOptions& options);

    uint32_t width() const { return levels()[0].width; }
    uint32_t height() const { return levels()[0].height; }
    uint32_t level_count() const { return static_cast<uint32_t>(levels().size()); }
    const Texels& texels() const { return *texels_; }
    const TextureOptions& options() const { return options_; }

    // r, g, b, a. The weights are computed in T.
    template <class T>
    std::array<T, 4> sample_lod(T u, T v, T lod) const;

private:
    template <class T>
    std::array<T, 4> bilinear(const Image& level, T u, T v) const;
    template <Wrap wrap, class T>
    std::array<T, 4> bilinear_of(const Image& level, T u, T v) const;
    template <Wrap wrap, class T>
    std::array<T, 4> nearest_of(const Image& level, T u, T v) const;
    template <class T>
    std::array<T, 4> nearest(const Image& level, T u, T v) const;

    const std::vector<Image>& levels() const { return texels_->chain()->levels; }

    std::shared_ptr<const Texels> texels_ = black();
    TextureOptions options_;

    static std::shared_ptr<const Texels> black();
};

}  // namespace wrinkle
