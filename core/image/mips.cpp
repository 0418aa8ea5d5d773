#include "image/mips.h"

#include <algorithm>
#include <bit>

namespace wrinkle {

namespace {

// Texels that a texel of the next level covers in one direction, with integer weights.
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

}  // namespace

uint32_t next_mip_size(uint32_t size) {
    return std::max(1u, size / 2);
}

uint32_t mip_count(uint32_t width, uint32_t height) {
    if (width == 0 || height == 0) return 0;
    return static_cast<uint32_t>(std::bit_width(std::max(width, height)));
}

CoveredRows covered_rows(uint32_t height, uint32_t y) {
    const Cover up = cover(height, y);
    return {up.first, up.count};
}

// The weights are integers, so the sums of a constant image are exact in double.
void half_row(uint32_t width, uint32_t height, uint32_t channels, uint32_t y,
              const float* const* rows, float* out) {
    const Cover up = cover(height, y);
    const size_t count = size_t{width} * channels;
    thread_local std::vector<double> sums;
    sums.assign(count, 0);
    double* sum = sums.data();
    for (uint32_t j = 0; j < up.count; ++j) {
        const float* row = rows[j];
        const double weight = up.weight[j];
        for (size_t i = 0; i < count; ++i)
            sum[i] += weight * row[i];
    }
    const double divisor = weight_sum(width) * weight_sum(height);
    const uint32_t half_width = next_mip_size(width);
    for (uint32_t x = 0; x < half_width; ++x) {
        const Cover across = cover(width, x);
        const double* in = sum + size_t{across.first} * channels;
        for (uint32_t c = 0; c < channels; ++c, ++in) {
            double total = across.weight[0] * in[0];
            for (uint32_t i = 1; i < across.count; ++i)
                total += across.weight[i] * in[size_t{i} * channels];
            *out++ = static_cast<float>(total / divisor);
        }
    }
}

Image half_size(const Image& image) {
    Image half = make_image(next_mip_size(image.width), next_mip_size(image.height), image.channels,
                            image.source);
    half.has_alpha = image.has_alpha;
    for (uint32_t y = 0; y < half.height; ++y) {
        const CoveredRows covered = covered_rows(image.height, y);
        const float* rows[3] = {};
        for (uint32_t j = 0; j < covered.count; ++j)
            rows[j] = image.texel(0, covered.first + j);
        half_row(image.width, image.height, image.channels, y, rows, half.texel(0, y));
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
