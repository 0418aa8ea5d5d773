// Fits the amplitude of a height map to the normal map of the same surface.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "base/diagnostics.h"
#include "maps/map.h"

namespace wrinkle::textures {

// Returns the height of white over black in texels, for which the slopes of the height map are
// nearest to those of the normal map (least squares over both axes, of means over squares of
// texels, so that the rounding of 8 bits averages out). std::nullopt if the maps differ in size,
// cannot be read, their slopes have a correlation below 0.5, or `stopped` returned true. The errors
// of reading are in `diagnostics`. Memory: about a million numbers, whatever the size.
std::optional<double> fitted_relief(const std::filesystem::path& height,
                                    const std::filesystem::path& normal, maps::Green green,
                                    Diagnostics& diagnostics,
                                    const std::function<bool()>& stopped = {});

}  // namespace wrinkle::textures
