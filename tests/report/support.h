// Images of tests of measures.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "image/load.h"
#include "image/texels.h"

namespace wrinkle::test {

inline const std::string flip_folder = WRINKLE_SOURCE_DIR "/tests/report/flip/";

// Returns an image of tests/report/flip as linear RGB.
inline Image linear_image(const std::string& name) {
    Diagnostics diagnostics;
    auto image = load_image(flip_folder + name, diagnostics);
    EXPECT_TRUE(image) << to_text(diagnostics);
    if (!image) return make_image(1, 1, 3);
    if (is_integer(image->source)) decode_srgb(*image);
    return *image;
}

inline Image image_of(uint32_t width, uint32_t height, uint32_t channels,
                      const std::vector<float>& data) {
    Image image = make_image(width, height, channels);
    image.data = data;
    return image;
}

inline Image filled(uint32_t width, uint32_t height, const std::vector<float>& texel) {
    Image image = make_image(width, height, static_cast<uint32_t>(texel.size()));
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = texel[i % texel.size()];
    return image;
}

// Returns the value at x, y from the top left.
inline float from_top(const Image& map, uint32_t x, uint32_t y) {
    return *map.texel(x, map.height - 1 - y);
}

}  // namespace wrinkle::test
