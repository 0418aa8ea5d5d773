// sRGB's transfer function (IEC 61966-2-1), in double.
#pragma once

#include "base/transcendental.h"

namespace wrinkle {

// Returns the linear light of a coded value from 0 to 1; negative values use the linear segment.
[[gnu::always_inline]] inline double linear_from_srgb(double coded) {
    return coded > 0.04045 ? math::pow((coded + 0.055) / 1.055, 2.4) : coded / 12.92;
}

[[gnu::always_inline]] inline double srgb_from_linear(double linear) {
    return linear > 0.0031308 ? 1.055 * math::pow(linear, 1 / 2.4) - 0.055 : 12.92 * linear;
}

}  // namespace wrinkle
