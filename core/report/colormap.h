// Color maps: magma for errors, viridis for exposures.
//
// Source: "mpl-colormaps" by N. Smith, S. van der Walt and E. Firing, 2015 (CC0).
#pragma once

#include <array>
#include <cstdint>

#include "image/image.h"

namespace wrinkle::report {

// 256 colors 0xRRGGBB, display-encoded.
using Colormap = std::array<uint32_t, 256>;
extern const Colormap magma, viridis;

// Returns an RGB image: values from 0 to `scale` select colors 0 to 255; others are clamped.
// Precondition: `map` has one channel, scale > 0.
Image colored(const Image& map, const Colormap& colors, double scale);

}  // namespace wrinkle::report
