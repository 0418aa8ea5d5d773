// Test bumps for maps: a height that repeats, with analytic slopes.
#pragma once

#include <cmath>
#include <numbers>

#include "image/image.h"

namespace wrinkle::test {

// h = sum of three waves with an integer number of periods over the image, in texels; its slopes
// per texel are analytic, not those of a filter.
struct Waves {
    uint32_t width = 128, height = 96;
    double strength = 1;

    struct At {
        double h, du, dv;
    };
    At at(double x, double y) const {
        constexpr double tau = 2 * std::numbers::pi;
        const double waves[3][4] = {{2, 1, 1.7, 0.3}, {-1, 3, 1.1, 1.9}, {5, 4, 0.6, 4}};
        At sum = {};
        for (const auto& [across, up, size, phase] : waves) {
            const double ku = tau * across / width, kv = tau * up / height;
            const double angle = ku * x + kv * y + phase;
            sum.h += strength * size * std::sin(angle);
            sum.du += strength * size * ku * std::cos(angle);
            sum.dv += strength * size * kv * std::cos(angle);
        }
        return sum;
    }
};

inline Image height_image(const Waves& waves) {
    Image image = make_image(waves.width, waves.height, 1);
    for (uint32_t y = 0; y < waves.height; ++y)
        for (uint32_t x = 0; x < waves.width; ++x)
            *image.texel(x, y) = static_cast<float>(waves.at(x, y).h);
    return image;
}

// Normals as decoded from a file of this type: (1 + n) / 2, green up.
inline Image normal_image(const Waves& waves, PixelType type = PixelType::u16) {
    Image image = make_image(waves.width, waves.height, 3, type);
    for (uint32_t y = 0; y < waves.height; ++y)
        for (uint32_t x = 0; x < waves.width; ++x) {
            const Waves::At at = waves.at(x, y);
            const double length = std::sqrt(at.du * at.du + at.dv * at.dv + 1);
            const double n[] = {-at.du / length, -at.dv / length, 1 / length};
            for (uint32_t c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>((1 + n[c]) / 2);
        }
    return image;
}

inline void quantise(Image& image, PixelType type) {
    const float steps = type == PixelType::u8 ? 255.0f : 65535.0f;
    image.source = type;
    for (float& value : image.data)
        value = std::round(value * steps) / steps;
}

}  // namespace wrinkle::test
