// A texture as GL samples it: mips, bilinear filtering, wrap modes.
//
// Texel (x, y) of a level has its centre at ((x + 1/2) / width, (y + 1/2) / height), v upward. The
// lod is clamped to the levels there are; between two levels results mix linearly. With the filter
// `nearest` the nearest texel of the nearest level is taken. NaN and infinite coordinates read as
// 0. Missing channels follow expand_texel() of image/image.h.
#pragma once

#include <array>
#include <vector>

#include "base/texture_options.h"
#include "image/mips.h"

namespace wrinkle {

class Texture {
public:
    Texture() = default;  // one black texel
    Texture(const MipChain& chain, const TextureOptions& options);

    uint32_t width() const { return levels_[0].width; }
    uint32_t height() const { return levels_[0].height; }

    // r, g, b, a. The weights are computed in T.
    template <class T>
    std::array<T, 4> sample_lod(T u, T v, T lod) const;

private:
    struct Level {
        uint32_t width = 1;
        uint32_t height = 1;
        std::vector<float> rgba{0, 0, 0, 1};
    };
    template <class T>
    std::array<T, 4> bilinear(const Level& level, T u, T v) const;
    template <class T>
    std::array<T, 4> nearest(const Level& level, T u, T v) const;

    std::vector<Level> levels_{Level{}};
    TextureOptions options_;
};

}  // namespace wrinkle
