#include "report/flip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/flip_stages.h"

namespace wrinkle::report {
namespace {

constexpr uint32_t band = 64;  // rows filtered at a time
constexpr double target = 0.85;

// t(x) = (k0 x^2 + k1 x + k2) / (k3 x^2 + k4 x + k5), per channel; of Reinhard the curve is that of
// the luminance.
using Curve = std::array<double, 6>;
constexpr std::array<Curve, 3> curves = {{
    {0.9036, 0.018, 0, 0.8748, 0.354, 0.14},
    {0.231683, 0.013791, 0, 0.18, 0.3, 0.018},
    {0, 1, 0, 0, 1, 1},
}};

const Curve& curve_of(Tone tone) {
    return curves[static_cast<size_t>(tone)];
}

double value_at(const Curve& k, double x) {
    return (k[0] * x * x + k[1] * x + k[2]) / (k[3] * x * x + k[4] * x + k[5]);
}

// Returns the larger x with t(x) = target.
double brightest_of(const Curve& k) {
    const double a = k[0] - target * k[3], b = k[1] - target * k[4], c = k[2] - target * k[5];
    if (a == 0) return -c / b;
    const double root = std::sqrt(b * b - 4 * a * c);
    return std::max((-b + root) / (2 * a), (-b - root) / (2 * a));
}

double luminance(const Color& rgb) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

// Returns element floor(n / 2) in ascending order; reorders the values.
double upper_median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Color light_at(const Image& image, size_t at) {
    const auto texel = expand_texel(&image.data[at], image.channels, image.has_alpha);
    Color rgb;
    for (size_t c = 0; c < 3; ++c)
        rgb[c] = std::max(texel[c], 0.0F);
    return rgb;
}

// In double, because squares of the largest floats are compared.
Color tone_mapped(const Color& rgb, Tone tone) {
    Color result;
    for (size_t c = 0; c < 3; ++c)
        result[c] = tone == Tone::reinhard ? rgb[c] / (1 + luminance(rgb))
                                           : value_at(curve_of(tone), rgb[c]);
    return result;
}

Image exposed(const Image& image, Tone tone, double exposure) {
    Image result = make_image(image.width, image.height, 3);
    const double scale = std::exp2(exposure);
    float* out = result.data.data();
    for (size_t at = 0; at < image.data.size(); at += image.channels) {
        Color rgb = light_at(image, at);
        for (double& value : rgb)
            value *= scale;
        for (const double value : tone_mapped(rgb, tone))
            *out++ = static_cast<float>(std::min(value, 1.0));
    }
    return result;
}

}  // namespace

Image flip(const Image& reference, const Image& test, double pixels_per_degree) {
    const Filters filters = make_filters(pixels_per_degree);
    Image errors = make_image(reference.width, reference.height, 1);
    const uint32_t bands = (reference.height + band - 1) / band;
    tbb::parallel_for(uint32_t{0}, bands, [&](uint32_t i) {
        const uint32_t first = i * band, rows = std::min(band, reference.height - first);
        const Stages a = make_stages(reference, filters, first, rows);
        const Stages b = make_stages(test, filters, first, rows);
        for (uint32_t y = 0; y < rows; ++y)
            for (uint32_t x = 0; x < errors.width; ++x)
                *errors.texel(x, first + y) = flip_error(a, b, x, y);
    });
    return errors;
}

std::optional<Tone> tone_named(std::string_view name) {
    const auto found = std::ranges::find(tone_names, name);
    if (found == tone_names.end()) return {};
    return static_cast<Tone>(found - tone_names.begin());
}

Exposures exposures_of(const Image& reference, Tone tone) {
    std::vector<double> lights;
    for (size_t at = 0; at < reference.data.size(); at += reference.channels)
        lights.push_back(luminance(light_at(reference, at)));
    double median = upper_median(lights);
    if (median == 0) {
        std::erase(lights, 0.0);
        if (lights.empty()) return {};
        median = upper_median(lights);
    }
    const double most = *std::ranges::max_element(lights);
    const double brightest = brightest_of(curve_of(tone));
    Exposures exposures;
    exposures.start = std::log2(brightest / most);
    exposures.stop = std::log2(brightest / median);
    const double count = std::ceil(exposures.stop - exposures.start);
    exposures.count = static_cast<uint32_t>(std::clamp<double>(count, 2, max_exposures));
    return exposures;
}

HdrFlip hdr_flip(const Image& reference, const Image& test, Tone tone, const Exposures& exposures,
                 double pixels_per_degree) {
    HdrFlip result;
    result.errors = result.exposures = make_image(reference.width, reference.height, 1);
    for (uint32_t i = 0; i < exposures.count; ++i) {
        const double exposure = exposures.at(i);
        const Image errors = flip(exposed(reference, tone, exposure), exposed(test, tone, exposure),
                                  pixels_per_degree);
        const float position = i == 0 ? 0 : static_cast<float>(i) / float(exposures.count - 1);
        for (size_t at = 0; at < errors.data.size(); ++at)
            if (errors.data[at] > result.errors.data[at]) {
                result.errors.data[at] = errors.data[at];
                result.exposures.data[at] = position;
            }
    }
    return result;
}

}  // namespace wrinkle::report
