#include "image/half.h"

namespace wrinkle {

namespace {

constexpr uint32_t bias_change = 112u << 23;  // 127 - 15 in the exponent bits

}  // namespace

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
