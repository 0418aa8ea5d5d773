#include "image/image.h"

#include <algorithm>

namespace wrinkle {

std::string_view name_of(PixelType type) {
    constexpr std::array<std::string_view, 4> names = {"u8", "u16", "half", "float"};
    return names[static_cast<size_t>(type)];
}

size_t bytes_of(PixelType type) {
    constexpr std::array<size_t, 4> sizes = {1, 2, 2, 4};
    return sizes[static_cast<size_t>(type)];
}

Image make_image(uint32_t width, uint32_t height, uint32_t channels, PixelType source) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.has_alpha = channels == 4;
    image.source = source;
    image.data.resize(static_cast<size_t>(width) * height * channels);
    return image;
}

Image to_rgba(const Image& image) {
    Image wide = make_image(image.width, image.height, 4, image.source);
    float* out = wide.data.data();
    for (size_t at = 0; at < image.data.size(); at += image.channels) {
        const auto texel = expand_texel(&image.data[at], image.channels, image.has_alpha);
        out = std::copy(texel.begin(), texel.end(), out);
    }
    return wide;
}

}  // namespace wrinkle
