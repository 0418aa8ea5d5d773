// An image in memory: float values, one to four channels, interleaved.
//
// Row 0 is the BOTTOM row and column 0 the left one, so the uv origin is the first value and texel
// (x, y) covers u in [x, x + 1] / width, v in [y, y + 1] / height. This is the order that
// glTexImage2D expects. Only loading and saving reverse the order of rows.
//
// Values are raw, without color conversion: an 8-bit 255 and a 16-bit 65535 are 1.0, values of
// float files are unchanged, including NaN and infinities. Alpha is never premultiplied.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace wrinkle {

// Storage type of a value in the file. u8 and u16 mean value / max in [0, 1].
enum class PixelType : uint8_t { u8, u16, half, float32 };

std::string_view name_of(PixelType type);  // "u8", "u16", "half", "float"
size_t bytes_of(PixelType type);
constexpr bool is_integer(PixelType type) {
    return type == PixelType::u8 || type == PixelType::u16;
}

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t channels = 0;                  // 1 gray, 2 (see has_alpha), 3 rgb, 4 rgba
    bool has_alpha = false;                 // with 2 channels: gray and alpha, else red and green
    PixelType source = PixelType::float32;  // type in the file; an upload may use it
    std::vector<float> data;                // [(y * width + x) * channels + channel], y up

    bool empty() const { return data.empty(); }
    const float* texel(uint32_t x, uint32_t y) const { return data.data() + offset(x, y); }
    float* texel(uint32_t x, uint32_t y) { return data.data() + offset(x, y); }

private:
    size_t offset(uint32_t x, uint32_t y) const {
        return (static_cast<size_t>(y) * width + x) * channels;
    }
};

// Returns an image of zeros; has_alpha is set for 4 channels.
Image make_image(uint32_t width, uint32_t height, uint32_t channels,
                 PixelType source = PixelType::float32);

// Expands one to four channels to four, the only rule for that: gray is repeated into r, g and b;
// red-green gets blue 0; a missing alpha is 1. `values` points at `channels` numbers.
template <class T>
std::array<T, 4> expand_texel(const T* values, uint32_t channels, bool has_alpha) {
    switch (channels) {
        case 1:
            return {values[0], values[0], values[0], 1};
        case 2:
            if (has_alpha) return {values[0], values[0], values[0], values[1]};
            return {values[0], values[1], 0, 1};
        case 3:
            return {values[0], values[1], values[2], 1};
        default:
            return {values[0], values[1], values[2], values[3]};
    }
}
Image to_rgba(const Image& image);  // expand_texel() on every texel

}  // namespace wrinkle
