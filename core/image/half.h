// Conversion between float and the 16 bits of IEEE 754 half precision.
#pragma once

#include <bit>
#include <cstdint>

namespace wrinkle {

// Rounds to nearest even; overflow becomes infinity, NaN stays NaN. All cases are computed and one
// is selected, so that loops that call it are vectorised.
inline uint16_t half_from_float(float value) {
    constexpr int32_t infinite = 0x7F800000;
    constexpr int32_t first_infinite = 0x477FF000;  // 65520, halfway from the largest half to 2^16
    constexpr int32_t first_normal = 0x38800000;    // 2^-14
    constexpr int32_t bias_change = 112 << 23;      // 127 - 15 in the exponent bits
    const int32_t bits = std::bit_cast<int32_t>(value);
    const int32_t magnitude = bits & 0x7FFFFFFF;
    // Floats in [0.5, 1) have steps of 2^-24, as subnormal halves do, so the addition rounds.
    const float counted = std::bit_cast<float>(magnitude) + 0.5f;
    const int32_t small = std::bit_cast<int32_t>(counted) - std::bit_cast<int32_t>(0.5f);
    const int32_t normal = (magnitude - bias_change + 0xFFF + ((magnitude >> 13) & 1)) >> 13;
    const int32_t finite = magnitude < first_normal ? small : normal;
    const int32_t large = magnitude > infinite ? 0x7E00 : 0x7C00;
    const int32_t half = magnitude < first_infinite ? finite : large;
    return static_cast<uint16_t>(((bits >> 16) & 0x8000) | half);
}

float float_from_half(uint16_t bits);  // exact

}  // namespace wrinkle
