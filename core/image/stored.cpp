#include "image/stored.h"

// Computes conversions inline: Imath's lookup table would require linking its library.
#define IMATH_HALF_NO_LOOKUP_TABLE
#include <Imath/half.h>

#include <algorithm>
#include <cstring>

namespace wrinkle {

namespace {

// Returns the value as an integer, 0 to max for [0, 1]: clamped, rounded to nearest, ties up. Not
// std::clamp: NaN must become 0. Branch-free, so that loops that call it are vectorised.
template <int max>
int rounded(float value) {
    const double positive = value > 0 ? value : 0;
    return static_cast<int>(std::min(positive, 1.0) * max + 0.5);
}

template <typename Stored, typename Convert>
void store_each(std::span<const float> values, std::byte* out, Convert convert) {
    for (size_t i = 0; i < values.size(); ++i) {
        const Stored stored = static_cast<Stored>(convert(values[i]));
        std::memcpy(out + i * sizeof stored, &stored, sizeof stored);
    }
}

template <typename Stored, typename Convert>
void convert_each(const std::byte* in, std::span<float> out, Convert convert) {
    for (size_t i = 0; i < out.size(); ++i) {
        Stored stored;
        std::memcpy(&stored, in + i * sizeof stored, sizeof stored);
        out[i] = convert(stored);
    }
}

}  // namespace

uint16_t half_from_float(float value) {
    return imath_float_to_half(value);
}

float float_from_half(uint16_t bits) {
    return imath_half_to_float(bits);
}

void store_values(PixelType type, std::span<const float> values, std::byte* out) {
    switch (type) {
        case PixelType::u8:
            return store_each<uint8_t>(values, out, rounded<255>);
        case PixelType::u16:
            return store_each<uint16_t>(values, out, rounded<65535>);
        case PixelType::half:
            return store_each<uint16_t>(values, out, half_from_float);
        case PixelType::float32:
            std::memcpy(out, values.data(), values.size_bytes());
    }
}

void values_from(PixelType type, const std::byte* stored, std::span<float> out) {
    switch (type) {
        case PixelType::u8:
            return convert_each<uint8_t>(stored, out, [](uint8_t v) { return v / 255.0f; });
        case PixelType::u16:
            return convert_each<uint16_t>(stored, out, [](uint16_t v) { return v / 65535.0f; });
        case PixelType::half:
            return convert_each<uint16_t>(stored, out, float_from_half);
        case PixelType::float32:
            std::memcpy(out.data(), stored, out.size_bytes());
    }
}

}  // namespace wrinkle
