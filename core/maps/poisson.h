// The height that slopes belong to.
//
// Least squares: of all heights h the one whose slopes (map.h's filter) are nearest to those given.
// It solves a Poisson equation by Fourier transforms, of the picture itself where it repeats and of
// its even extension where it clamps. The slopes of a height give that height again, but for its
// mean, which no slope knows and which is made 0, and for what the filter does not see: ripples of
// two texels. They are damped: a penalty of 1e-4 on the squared Laplacian takes 4e-4 off a ripple
// of four texels, and keeps noise of two from growing without bound.
//
// Slopes that no height has (curl) come out as the nearest that one has. With a mean slope that is
// not zero a repeating map has no height: the mean is left out.
#pragma once

#include <cstdint>
#include <vector>

#include "base/texture_options.h"

namespace wrinkle::maps {

// du and dv row by row, per texel; NaN and infinities count as 0. Takes 8 bytes for each texel
// where it repeats and 32 where it clamps.
std::vector<float> height_of_slopes(std::vector<float> du, std::vector<float> dv, uint32_t width,
                                    uint32_t height, Wrap wrap);

}  // namespace wrinkle::maps
