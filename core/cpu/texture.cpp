#include "cpu/texture.h"

#include <cmath>

#include "cpu/wrap.h"
#include "image/image.h"

namespace wrinkle {

namespace {

template <Wrap wrap, class T>
std::array<T, 4> bilinear(const Image& level, T u, T v) {
    const T x = wrapped<wrap>(u) * static_cast<T>(level.width) - T(0.5);
    const T y = wrapped<wrap>(v) * static_cast<T>(level.height) - T(0.5);
    const T x_floor = std::floor(x), y_floor = std::floor(y);
    const T fx = x - x_floor, fy = y - y_floor;
    const auto column = static_cast<int64_t>(x_floor), row = static_cast<int64_t>(y_floor);
    const auto texel = [&](int64_t i, int64_t j) {
        return level.texel(
            static_cast<uint32_t>(texel_index<wrap>(column + i, int64_t{level.width})),
            static_cast<uint32_t>(texel_index<wrap>(row + j, int64_t{level.height})));
    };
    const float *a = texel(0, 0), *b = texel(1, 0), *c = texel(0, 1), *d = texel(1, 1);
    std::array<T, 4> result{};
    for (size_t k = 0; k < level.channels; ++k) {
        const T low = T(a[k]) + (T(b[k]) - T(a[k])) * fx;
        const T high = T(c[k]) + (T(d[k]) - T(c[k])) * fx;
        result[k] = low + (high - low) * fy;
    }
    return expand_texel(result.data(), level.channels, level.has_alpha);
}

template <Wrap wrap, class T>
std::array<T, 4> nearest(const Image& level, T u, T v) {
    const T x = std::floor(wrapped<wrap>(u) * static_cast<T>(level.width));
    const T y = std::floor(wrapped<wrap>(v) * static_cast<T>(level.height));
    const auto column = texel_index<Wrap::clamp>(static_cast<int64_t>(x), int64_t{level.width});
    const auto row = texel_index<Wrap::clamp>(static_cast<int64_t>(y), int64_t{level.height});
    const float* found = level.texel(static_cast<uint32_t>(column), static_cast<uint32_t>(row));
    const auto rgba = expand_texel(found, level.channels, level.has_alpha);
    return {T(rgba[0]), T(rgba[1]), T(rgba[2]), T(rgba[3])};
}

template <Wrap wrap, class T>
std::array<T, 4> sampled(const std::vector<Image>& levels, Filter filter, T u, T v, T lod) {
    const auto last = static_cast<T>(levels.size() - 1);
    const T inside = lod > 0 ? (lod < last ? lod : last) : T(0);  // NaN reads level 0
    if (filter == Filter::nearest)
        return nearest<wrap>(levels[static_cast<size_t>(inside + T(0.5))], u, v);
    const T base = std::floor(inside);
    const T between = inside - base;
    const auto level = static_cast<size_t>(base);
    std::array<T, 4> result = bilinear<wrap>(levels[level], u, v);
    if (between <= 0) return result;
    const std::array<T, 4> coarser = bilinear<wrap>(levels[level + 1], u, v);
    for (size_t k = 0; k < 4; ++k)
        result[k] += (coarser[k] - result[k]) * between;
    return result;
}

}  // namespace

std::shared_ptr<const PackedMipChain> Texture::black() {
    static const std::shared_ptr<const PackedMipChain> texels = [] {
        Image texel = make_image(1, 1, 4);
        texel.data = {0, 0, 0, 1};
        return std::make_shared<const PackedMipChain>(
            std::make_shared<const MipChain>(build_mips(std::move(texel))));
    }();
    return texels;
}

Texture::Texture(std::shared_ptr<const PackedMipChain> texels, const TextureOptions& options)
    : options_(options) {
    if (texels && !texels->chain()->levels.empty()) texels_ = std::move(texels);
}

Texture::Texture(MipChain chain, const TextureOptions& options)
    : Texture(std::make_shared<const PackedMipChain>(
                  std::make_shared<const MipChain>(std::move(chain))),
              options) {}

template <class T>
std::array<T, 4> Texture::sample_lod(T u, T v, T lod) const {
    return with_wrap(options_.wrap, [&](auto wrap) {
        return sampled<wrap.value>(levels(), options_.filter, u, v, lod);
    });
}

template std::array<float, 4> Texture::sample_lod(float, float, float) const;
template std::array<double, 4> Texture::sample_lod(double, double, double) const;

}  // namespace wrinkle
