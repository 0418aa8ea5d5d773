// Where vertex shaders find the surface's properties: one table for generated and for own shaders,
// and for the buffers of a mesh.
#pragma once

#include <array>

#include "ir/module.h"

namespace wrinkle {

// By SurfaceInput; -1: made in the shader.
inline constexpr std::array<int, surface_input_count> attribute_locations = {0, 1, 2, 3,  4,
                                                                             5, 6, 7, -1, -1};
inline constexpr int attribute_count = 8;  // the locations from here on are free

constexpr int location_of(SurfaceInput input) {
    return attribute_locations[static_cast<size_t>(input)];
}

}  // namespace wrinkle
