// Conversion of arrays of floats to and from the values that a file stores.
//
// u8 and u16 clamp to [0, 1] and round to the nearest step, ties up; NaN becomes 0. half rounds to
// nearest even. The conversion to float is exact except for the division by 255 or 65535 in float.
#pragma once

#include <cstddef>
#include <span>

#include "image/image.h"

namespace wrinkle {

// Writes values.size() * bytes_of(type) bytes.
void store_values(PixelType type, std::span<const float> values, std::byte* out);
void values_from(PixelType type, const std::byte* stored, std::span<float> out);

}  // namespace wrinkle
