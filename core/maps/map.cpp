#include "maps/map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/normals.h"

namespace wrinkle::maps {

namespace {

constexpr auto max_slope_float = static_cast<float>(max_slope);
constexpr auto min_depth_float = static_cast<float>(min_depth);

// Returns the index before or after `index`, wrapped or clamped at the border.
uint32_t neighbour(uint32_t index, int step, uint32_t size, Wrap wrap) {
    if (step < 0) return index > 0 ? index - 1 : wrap == Wrap::repeat ? size - 1 : 0;
    return index + 1 < size ? index + 1 : wrap == Wrap::repeat ? 0 : index;
}

}  // namespace

void slopes_of_normals(const float* texels, uint32_t stride, uint32_t channels, float green,
                       uint32_t count, float* du, float* dv) {
    for (uint32_t i = 0; i < count; ++i, texels += stride) {
        const float x = 2 * texels[0] - 1;
        const float y = channels > 1 ? green * (2 * texels[1] - 1) : 0;
        const float z = channels > 2 ? std::abs(2 * texels[2] - 1)
                                     : std::sqrt(std::max(0.0f, 1 - x * x - y * y));
        const float least =
            std::max(std::max(std::abs(x), std::abs(y)) / max_slope_float, min_depth_float);
        const float depth = std::max(z, least);
        du[i] = -x / depth;
        dv[i] = -y / depth;
    }
}

void multiply(float* du, float across, float* dv, float up, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        du[i] *= across;
        dv[i] *= up;
    }
}

void sobel_row(const ThreeRows& heights, uint32_t count, Wrap wrap, float* du, float* dv) {
    const auto& [above, here, below] = heights;
    // One value per column, plus one padding column at each end.
    thread_local std::vector<float> sums, steps;
    sums.resize(count + 2);
    steps.resize(count + 2);
    float* sum = sums.data() + 1;
    float* step = steps.data() + 1;
    for (uint32_t x = 0; x < count; ++x) {
        sum[x] = above[x] + 2 * here[x] + below[x];
        step[x] = above[x] - below[x];
    }
    const uint32_t left = neighbour(0, -1, count, wrap);
    const uint32_t right = neighbour(count - 1, 1, count, wrap);
    sum[-1] = sum[left], step[-1] = step[left];
    sum[count] = sum[right], step[count] = step[right];
    for (uint32_t x = 0; x < count; ++x) {
        du[x] = sum[x + 1] - sums[x];
        dv[x] = steps[x] + 2 * step[x] + step[x + 1];
    }
}

Rows::Rows(const Source& source) : source_(source) {
    assert(source.kind != Kind::slopes && source.kind != Kind::moments);
    const Image& image = *source.image;
    if (source.kind != Kind::height) return;
    heights_ = image.data.data();
    if (image.channels == 1 && source.factor == 1 && source.offset == 0) return;
    made_.resize(size_t{image.width} * image.height);
    for (size_t i = 0; i < made_.size(); ++i) {
        const float* texel = &image.data[i * image.channels];
        const float mean = image.channels >= 3 ? (texel[0] + texel[1] + texel[2]) / 3 : texel[0];
        made_[i] = mean * source.factor + source.offset;
    }
    heights_ = made_.data();
}

void Rows::slopes(uint32_t y, float* du, float* dv) const {
    heights_ ? sobel(y, du, dv) : decode(y, du, dv);
}

void Rows::sobel(uint32_t y, float* du, float* dv) const {
    const uint32_t count = width();
    const ThreeRows rows = {heights(neighbour(y, 1, height(), source_.wrap)), heights(y),
                            heights(neighbour(y, -1, height(), source_.wrap))};
    sobel_row(rows, count, source_.wrap, du, dv);
    multiply(du, 1 / (8 * source_.texel_width), dv, 1 / (8 * source_.texel_height), count);
}

void Rows::decode(uint32_t y, float* du, float* dv) const {
    const Image& image = *source_.image;
    const uint32_t channels = image.channels - (image.has_alpha ? 1 : 0);
    const float* texel = image.texel(0, y);
    const bool normal = source_.kind == Kind::normal;
    const bool integers = is_integer(image.source);
    const float scale = integers ? source_.stored_scale : 0.5f, middle = integers ? 1.0f : 0.0f;
    const bool uv = source_.per == Per::uv && !normal;
    const float across = source_.factor / (uv ? static_cast<float>(width()) : 1);
    const float up = source_.factor / (uv ? static_cast<float>(height()) : 1);
    const float green = source_.green == Green::dx ? -1.0f : 1.0f;
    if (normal) slopes_of_normals(texel, image.channels, channels, green, width(), du, dv);
    for (uint32_t x = 0; x < width() && !normal; ++x, texel += image.channels) {
        const float second = channels > 1 ? texel[1] : middle / 2;
        du[x] = scale * (2 * texel[0] - middle);
        dv[x] = scale * (2 * second - middle);
    }
    multiply(du, across, dv, up, width());
}

}  // namespace wrinkle::maps
