// Integrates slopes to a height.
//
// Least squares (Frankot and Chellappa 1988): finds the height h with slopes (map.h's filter)
// nearest to the given ones. Solves a Poisson equation by Fourier transforms, of the image itself
// (repeat) or of its even extension (clamp). The slopes of a height yield that height again, except
// for its mean, which is set to 0, and for ripples of two texels, to which the filter does not
// respond. These are damped: a penalty of 1e-4 on the squared Laplacian reduces a ripple of four
// texels by 4e-4 of its height, and bounds noise with a period of two texels.
#pragma once

#include <cstdint>
#include <vector>

#include "base/texture_options.h"

namespace wrinkle::maps {

// Non-integrable slopes (with curl) yield the height with the nearest slopes. A repeating height
// has zero mean slope, so a mean slope is dropped for Wrap::repeat.
//
// du and dv row by row, per texel; NaN and infinities count as 0. Needs 8 bytes per texel for
// Wrap::repeat and 32 for Wrap::clamp.
std::vector<float> height_of_slopes(std::vector<float> du, std::vector<float> dv, uint32_t width,
                                    uint32_t height, Wrap wrap);

}  // namespace wrinkle::maps
