#include "image/mips.h"

#include <algorithm>
#include <bit>

namespace wrinkle {

namespace {

// The texels of one direction that a texel of the next level covers, with integer weights.
struct Cover {
    uint32_t first = 0;
    uint32_t count = 0;
    double weight[3] = {};
};

Cover cover(uint32_t size, uint32_t index) {
    if (size == 1) return {0, 1, {1}};
    if (size % 2 == 0) return {2 * index, 2, {1, 1}};
    const uint32_t half = size / 2;
    return {2 * index, 3, {double(half - index), double(half), double(index + 1)}};
}

double weight_sum(uint32_t size) {
    return size % 2 == 0 ? 2 : size;
}

// The weights are integers, so the sums of a constant image are exact in double.
void mean_texel(const Image& from, const Cover& across, const Cover& up, double divisor,
                float* out) {
    double sum[4] = {};
    for (uint32_t j = 0; j < up.count; ++j) {
        const float* in = from.texel(across.first, up.first + j);
        for (uint32_t i = 0; i < across.count; ++i) {
            const double weight = across.weight[i] * up.weight[j];
            for (uint32_t c = 0; c < from.channels; ++c)
                sum[c] += weight * *in++;
        }
    }
    for (uint32_t c = 0; c < from.channels; ++c)
        out[c] = static_cast<float>(sum[c] / divisor);
}

}  // namespace

uint32_t next_mip_size(uint32_t size) {
    return std::max(1u, size / 2);
}

uint32_t mip_count(uint32_t width, uint32_t height) {
    if (width == 0 || height == 0) return 0;
    return static_cast<uint32_t>(std::bit_width(std::max(width, height)));
}

Image half_size(const Image& image) {
    Image half = make_image(next_mip_size(image.width), next_mip_size(image.height), image.channels,
                            image.source);
    half.has_alpha = image.has_alpha;
    const double divisor = weight_sum(image.width) * weight_sum(image.height);
    for (uint32_t y = 0; y < half.height; ++y) {
        const Cover up = cover(image.height, y);
        for (uint32_t x = 0; x < half.width; ++x)
            mean_texel(image, cover(image.width, x), up, divisor, half.texel(x, y));
    }
    return half;
}

MipChain build_mips(Image base) {
    MipChain chain;
    const uint32_t count = mip_count(base.width, base.height);
    if (count == 0) return chain;
    chain.levels.reserve(count);
    chain.levels.push_back(std::move(base));
    while (chain.levels.size() < count)
        chain.levels.push_back(half_size(chain.levels.back()));
    return chain;
}

}  // namespace wrinkle
