// Conversion of arrays of floats to and from the values that a file stores.
//
// u8 and u16 clamp to [0, 1] and round to the nearest step, ties up; NaN becomes 0. half rounds to
// nearest even; overflow becomes infinity, NaN stays NaN. The conversion to float is exact except
// for the division by 255 or 65535 in float.
//
// Written by hand for integers because OpenImageIO's conversion is in a module that is loaded for
// some formats only, and does not define the value of NaN.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "image/image.h"

namespace wrinkle {

// Writes values.size() * bytes_of(type) bytes.
void store_values(PixelType type, std::span<const float> values, std::byte* out);
void values_from(PixelType type, const std::byte* stored, std::span<float> out);

// Conversion of one value to and from the 16 bits of IEEE 754 half precision, by Imath.
uint16_t half_from_float(float value);
float float_from_half(uint16_t bits);

}  // namespace wrinkle
