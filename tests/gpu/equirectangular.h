// Environment images of closed forms.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "image/image.h"

namespace wrinkle::gpu {

// An image with the radiance `of(direction)` in each direction, laid out as the header documents.
template <typename F>
inline Image equirectangular(F of, uint32_t height = 64) {
    Image image = make_image(2 * height, height, 3);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < 2 * height; ++x) {
            const double elevation = ((y + 0.5) / height - 0.5) * M_PI;
            const double turn = ((x + 0.5) / (2 * height) - 0.5) * 2 * M_PI;
            const glm::vec3 radiance =
                of(glm::dvec3(std::cos(elevation) * std::sin(turn), std::sin(elevation),
                              -std::cos(elevation) * std::cos(turn)));
            for (int k = 0; k < 3; ++k)
                image.texel(x, y)[k] = radiance[k];
        }
    return image;
}

}  // namespace wrinkle::gpu
