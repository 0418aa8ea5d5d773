#include "image/half.h"

#include <bit>
#include <cmath>

namespace wrinkle {

namespace {

constexpr uint32_t first_infinite = 0x477FF000;  // 65520, halfway from the largest half to 2^16
constexpr uint32_t first_normal = 0x38800000;    // 2^-14
constexpr uint32_t bias_change = 112u << 23;     // 127 - 15 in the exponent's place

}  // namespace

uint16_t half_from_float(float value) {
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    const uint32_t sign = (bits >> 16) & 0x8000;
    const uint32_t magnitude = bits & 0x7FFFFFFF;
    uint32_t half = 0;
    if (magnitude > 0x7F800000)
        half = 0x7E00;
    else if (magnitude >= first_infinite)
        half = 0x7C00;
    else if (magnitude < first_normal)
        half = static_cast<uint32_t>(std::lrint(std::bit_cast<float>(magnitude) * 0x1p24f));
    else
        half = (magnitude - bias_change + 0xFFF + ((magnitude >> 13) & 1)) >> 13;
    return static_cast<uint16_t>(sign | half);
}

float float_from_half(uint16_t bits) {
    const uint32_t sign = (bits & 0x8000u) << 16;
    const uint32_t exponent = (bits >> 10) & 0x1F;
    const uint32_t mantissa = bits & 0x3FFu;
    if (exponent == 0) {
        const float magnitude = static_cast<float>(mantissa) * 0x1p-24f;
        return sign ? -magnitude : magnitude;
    }
    const uint32_t wide = exponent == 31 ? 0x7F800000 : (exponent << 23) + bias_change;
    return std::bit_cast<float>(sign | wide | (mantissa << 13));
}

}  // namespace wrinkle
