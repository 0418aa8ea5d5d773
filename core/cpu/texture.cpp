#include "cpu/texture.h"

#include <cmath>

#include "image/image.h"

namespace wrinkle {
namespace {

// A coordinate brought into [0, 1] by the wrap mode (clamp leaves room for the border's half
// texel).
template <class T>
T wrapped(T x, Wrap wrap) {
    if (!(std::fabs(x) < T(1e9))) return 0;  // NaN too
    switch (wrap) {
        case Wrap::repeat:
            return x - std::floor(x);
        case Wrap::clamp:
            return x < 0 ? T(0) : x > 1 ? T(1) : x;
        case Wrap::mirror: {
            const T period = x - 2 * std::floor(x / 2);
            return period > 1 ? 2 - period : period;
        }
    }
    return 0;
}

int64_t texel_index(int64_t i, uint32_t size, Wrap wrap) {
    const auto n = static_cast<int64_t>(size);
    if (wrap == Wrap::repeat) return i < 0 ? i + n : i >= n ? i - n : i;
    return i < 0 ? 0 : i >= n ? n - 1 : i;
}

}  // namespace

std::shared_ptr<const MipChain> Texture::black() {
    static const std::shared_ptr<const MipChain> chain = [] {
        Image texel = make_image(1, 1, 4);
        texel.data = {0, 0, 0, 1};
        return std::make_shared<const MipChain>(build_mips(std::move(texel)));
    }();
    return chain;
}

Texture::Texture(std::shared_ptr<const MipChain> chain, const TextureOptions& options)
    : options_(options) {
    if (chain && !chain->levels.empty()) chain_ = std::move(chain);
}

Texture::Texture(MipChain chain, const TextureOptions& options)
    : Texture(std::make_shared<const MipChain>(std::move(chain)), options) {}

template <class T, uint32_t channels>
std::array<T, 4> Texture::bilinear_of(const Image& level, T u, T v) const {
    const T x = wrapped(u, options_.wrap) * static_cast<T>(level.width) - T(0.5);
    const T y = wrapped(v, options_.wrap) * static_cast<T>(level.height) - T(0.5);
    const T x_floor = std::floor(x), y_floor = std::floor(y);
    const T fx = x - x_floor, fy = y - y_floor;
    const auto column = static_cast<int64_t>(x_floor), row = static_cast<int64_t>(y_floor);
    const auto texel = [&](int64_t i, int64_t j) {
        const int64_t at = texel_index(row + j, level.height, options_.wrap) * level.width +
                           texel_index(column + i, level.width, options_.wrap);
        return level.data.data() + at * channels;
    };
    const float *a = texel(0, 0), *b = texel(1, 0), *c = texel(0, 1), *d = texel(1, 1);
    std::array<T, channels> result;
    for (size_t k = 0; k < channels; ++k) {
        const T low = T(a[k]) + (T(b[k]) - T(a[k])) * fx;
        const T high = T(c[k]) + (T(d[k]) - T(c[k])) * fx;
        result[k] = low + (high - low) * fy;
    }
    return expand_texel(result.data(), channels, level.has_alpha);
}

template <class T>
std::array<T, 4> Texture::bilinear(const Image& level, T u, T v) const {
    switch (level.channels) {
        case 1:
            return bilinear_of<T, 1>(level, u, v);
        case 2:
            return bilinear_of<T, 2>(level, u, v);
        case 3:
            return bilinear_of<T, 3>(level, u, v);
        default:
            return bilinear_of<T, 4>(level, u, v);
    }
}

template <class T>
std::array<T, 4> Texture::nearest(const Image& level, T u, T v) const {
    const T x = std::floor(wrapped(u, options_.wrap) * static_cast<T>(level.width));
    const T y = std::floor(wrapped(v, options_.wrap) * static_cast<T>(level.height));
    const int64_t column = texel_index(static_cast<int64_t>(x), level.width, Wrap::clamp);
    const int64_t row = texel_index(static_cast<int64_t>(y), level.height, Wrap::clamp);
    const float* found = level.texel(static_cast<uint32_t>(column), static_cast<uint32_t>(row));
    const auto rgba = expand_texel(found, level.channels, level.has_alpha);
    return {T(rgba[0]), T(rgba[1]), T(rgba[2]), T(rgba[3])};
}

template <class T>
std::array<T, 4> Texture::sample_lod(T u, T v, T lod) const {
    const std::vector<Image>& levels = chain_->levels;
    const auto last = static_cast<T>(levels.size() - 1);
    const T inside = lod > 0 ? (lod < last ? lod : last) : T(0);  // NaN reads level 0
    if (options_.filter == Filter::nearest)
        return nearest(levels[static_cast<size_t>(inside + T(0.5))], u, v);
    const T base = std::floor(inside);
    const T between = inside - base;
    const auto level = static_cast<size_t>(base);
    std::array<T, 4> result = bilinear(levels[level], u, v);
    if (between <= 0) return result;
    const std::array<T, 4> coarser = bilinear(levels[level + 1], u, v);
    for (size_t k = 0; k < 4; ++k)
        result[k] += (coarser[k] - result[k]) * between;
    return result;
}

template std::array<float, 4> Texture::sample_lod(float, float, float) const;
template std::array<double, 4> Texture::sample_lod(double, double, double) const;

}  // namespace wrinkle
