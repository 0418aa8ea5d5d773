#include "maps/measures.h"

#include <algorithm>
#include <cmath>

namespace wrinkle::maps {

namespace {

constexpr double unit_tolerance = 0.1;
constexpr float spike = 4;

template <typename Use>
void each_texel(const Image& image, Use use) {
    const size_t count = size_t{image.width} * image.height;
    for (size_t i = 0; i < count; ++i)
        use(&image.data[i * image.channels]);
}

float highest_steps(PixelType type) {
    return type == PixelType::u8 ? 255.0f : 65535.0f;
}

}  // namespace

VectorMeasures measure_vectors(const Image& image) {
    VectorMeasures sums;
    double lowest_blue = INFINITY, highest_blue = -INFINITY;
    size_t empty = 0;
    each_texel(image, [&](const float* t) {
        if (t[0] == 0 && t[1] == 0 && t[2] == 0) {
            ++empty;
            return;
        }
        const double x = 2.0 * t[0] - 1, y = 2.0 * t[1] - 1, z = 2.0 * t[2] - 1;
        const double made = std::sqrt(std::max(0.0, 1 - x * x - y * y));
        sums.unit += std::abs(std::sqrt(x * x + y * y + z * z) - 1) < unit_tolerance;
        sums.downward += z < -unit_tolerance;
        const auto [low, high] = std::minmax({t[0], t[1], t[2]});
        sums.gray += high - low < 2.5 * u8_step;
        const double values[] = {x, y, z};
        for (size_t c = 0; c < 3; ++c)
            sums.mean[c] += values[c];
        const double with_sign = t[2] - (1 + made) / 2, without = t[2] - made;
        sums.signed_z += with_sign * with_sign;
        sums.unsigned_z += without * without;
        sums.between_z += (1 - made) * (1 - made) / 4;
        lowest_blue = std::min<double>(lowest_blue, t[2]);
        highest_blue = std::max<double>(highest_blue, t[2]);
    });
    const double all = static_cast<double>(image.width) * image.height;
    sums.empty = static_cast<double>(empty) / all;
    const double count = std::max(all - static_cast<double>(empty), 1.0);
    for (double* share :
         {&sums.unit, &sums.downward, &sums.gray, &sums.mean[0], &sums.mean[1], &sums.mean[2]})
        *share /= count;
    for (double* square : {&sums.signed_z, &sums.unsigned_z, &sums.between_z})
        *square = std::sqrt(*square / count);
    sums.blue_spread = highest_blue - lowest_blue;
    return sums;
}

namespace {

// One of the two slopes as a picture, so that the filter of slopes can be put on it again.
struct SlopePictures {
    Image du, dv;
};

SlopePictures slope_pictures(const Image& image, bool made_z) {
    Image two = image;
    if (made_z && image.channels > 2) {  // z is made for pictures of two channels
        two = make_image(image.width, image.height, 2, image.source);
        for (size_t i = 0; i < two.data.size() / 2; ++i)
            std::copy_n(&image.data[i * image.channels], 2, &two.data[i * 2]);
    }
    Source source;
    source.image = &two;
    source.kind = Kind::normal;
    const Rows rows(source);
    SlopePictures slopes{make_image(image.width, image.height, 1),
                         make_image(image.width, image.height, 1)};
    for (uint32_t y = 0; y < image.height; ++y)
        rows.slopes(y, slopes.du.texel(0, y), slopes.dv.texel(0, y));
    for (Image* slope : {&slopes.du, &slopes.dv})
        for (float& value : slope->data)
            value = std::isfinite(value) ? std::clamp(value, -spike, spike) : 0;
    return slopes;
}

}  // namespace

CurlMeasures measure_curl(const Image& image, bool made_z, Wrap wrap) {
    const SlopePictures slopes = slope_pictures(image, made_z);
    Source of_du, of_dv;
    of_du.image = &slopes.du;
    of_dv.image = &slopes.dv;
    of_du.wrap = of_dv.wrap = wrap;
    const Rows du(of_du), dv(of_dv);
    std::vector<float> unused(image.width), u_along_v(image.width), v_along_u(image.width);
    double uu = 0, vv = 0, uv = 0;
    for (uint32_t y = 0; y < image.height; ++y) {
        du.slopes(y, unused.data(), u_along_v.data());
        dv.slopes(y, v_along_u.data(), unused.data());
        for (uint32_t x = 0; x < image.width; ++x) {
            const double a = u_along_v[x], b = v_along_u[x];
            uu += a * a;
            vv += b * b;
            uv += a * b;
        }
    }
    const double count = static_cast<double>(image.width) * image.height;
    CurlMeasures curl;
    curl.gl = std::sqrt(std::max(0.0, uu - 2 * uv + vv) / count);
    curl.dx = std::sqrt(std::max(0.0, uu + 2 * uv + vv) / count);
    curl.correlation = uu > 0 && vv > 0 ? uv / std::sqrt(uu * vv) : 0;
    return curl;
}

OffsetMeasures measure_offset(const Image& image) {
    OffsetMeasures offset;
    size_t tilted = 0;
    each_texel(image, [&](const float* t) {
        const double red = t[0] * 255.0 - 127.5, green = t[1] * 255.0 - 127.5;
        if (std::abs(red) < 1 && std::abs(green) < 1) return;
        offset.red += red;
        offset.green += green;
        ++tilted;
    });
    if (tilted > 0) {
        offset.red /= static_cast<double>(tilted);
        offset.green /= static_cast<double>(tilted);
    }
    offset.tilted = static_cast<double>(tilted) / (static_cast<double>(image.width) * image.height);
    return offset;
}

StepMeasures measure_steps(const Image& image, uint32_t channel) {
    StepMeasures steps;
    if (image.source != PixelType::u8 && image.source != PixelType::u16) return steps;
    const float highest = highest_steps(image.source);
    const auto value = [&](uint32_t x, uint32_t y) {
        return static_cast<int>(std::lround(image.texel(x, y)[channel] * highest));
    };
    std::vector<char> seen(65536);
    size_t still = 0, one = 0, pairs = 0;
    const auto compare = [&](int a, int b) {
        still += a == b;
        one += std::abs(a - b) == 1;
        ++pairs;
    };
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const int here = value(x, y);
            seen[static_cast<size_t>(here)] = 1;
            if (x + 1 < image.width) compare(here, value(x + 1, y));
            if (y + 1 < image.height) compare(here, value(x, y + 1));
        }
    steps.eight_bits = image.source == PixelType::u16;
    for (size_t i = 0; i < seen.size(); ++i) {
        steps.levels += seen[i] ? 1 : 0;
        if (seen[i] && i % 257 != 0) steps.eight_bits = false;
    }
    steps.still = pairs ? static_cast<double>(still) / static_cast<double>(pairs) : 0;
    steps.one = pairs ? static_cast<double>(one) / static_cast<double>(pairs) : 0;
    return steps;
}

SeamMeasures measure_seam(const Image& image, uint32_t channels, bool across_u) {
    const uint32_t lines = across_u ? image.width : image.height;
    const uint32_t length = across_u ? image.height : image.width;
    std::vector<double> sums(lines);  // of the steps from each line to the next
    const auto add = [&](uint32_t line, const float* a, const float* b) {
        double sum = 0;
        for (uint32_t c = 0; c < channels; ++c)
            sum += std::isfinite(a[c] - b[c]) ? std::abs(static_cast<double>(a[c]) - b[c]) : 0;
        sums[line] += sum;
    };
    for (uint32_t y = 0; y < image.height; ++y)  // in the order of memory
        for (uint32_t x = 0; x < image.width; ++x)
            if (across_u)
                add(x, image.texel(x, y), image.texel((x + 1) % lines, y));
            else
                add(y, image.texel(x, y), image.texel(x, (y + 1) % lines));
    for (double& sum : sums)
        sum /= static_cast<double>(length) * channels;
    const double border = sums.back();
    sums.pop_back();
    std::vector<double>& inside = sums;
    if (inside.empty()) return {};
    const auto place = inside.begin() + static_cast<ptrdiff_t>((inside.size() - 1) * 99 / 100);
    std::nth_element(inside.begin(), place, inside.end());
    return {border, *place};
}

}  // namespace wrinkle::maps
