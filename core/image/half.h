// IEEE 754 half-precision values as their 16 bits.
#pragma once

#include <cstdint>

namespace wrinkle {

uint16_t half_from_float(float value);  // to nearest even; too large is infinity, NaN stays NaN
float float_from_half(uint16_t bits);   // exact

}  // namespace wrinkle
