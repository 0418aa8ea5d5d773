#include "report/measures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/normals.h"

namespace wrinkle::report {
namespace {

using Normal = std::array<double, 3>;

// Returns the measure of each pair of texels.
template <class Measure>
Image measured(const Image& reference, const Image& test, const Measure& measure) {
    Image map = make_image(reference.width, reference.height, 1);
    tbb::parallel_for(uint32_t{0}, map.height, [&](uint32_t y) {
        for (uint32_t x = 0; x < map.width; ++x)
            *map.texel(x, y) = static_cast<float>(measure(reference.texel(x, y), test.texel(x, y)));
    });
    return map;
}

Normal normal_at(const float* texel, uint32_t channels) {
    Normal n = {2.0 * texel[0] - 1, 2.0 * texel[1] - 1, 0};
    n[2] = channels == 2 ? std::sqrt(std::max(0.0, 1 - n[0] * n[0] - n[1] * n[1]))
                         : 2.0 * texel[2] - 1;
    return n;
}

double angle_between(const Normal& a, const Normal& b) {
    const double angle = degrees_between(a, b);
    if (!std::isnan(angle)) return angle;
    return a == b ? 0 : 180;
}

}  // namespace

bool has_normals(const Image& image) {
    return image.channels > 2 || (image.channels == 2 && !image.has_alpha);
}

Image degrees_apart(const Image& reference, const Image& test) {
    return measured(reference, test, [&](const float* a, const float* b) {
        return angle_between(normal_at(a, reference.channels), normal_at(b, test.channels));
    });
}

Image steps_apart(const Image& reference, const Image& test) {
    return measured(reference, test, [&](const float* a, const float* b) {
        const auto p = expand_texel(a, reference.channels, reference.has_alpha);
        const auto q = expand_texel(b, test.channels, test.has_alpha);
        double sum = 0;
        for (size_t c = 0; c < 4; ++c)
            sum += std::pow((double{p[c]} - q[c]) * 255, 2);
        return std::sqrt(sum / 4);
    });
}

}  // namespace wrinkle::report
