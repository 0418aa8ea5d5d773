// Vertex attribute locations of the surface's properties: one table for generated shaders, for the
// application's own shaders, and for mesh buffers.
#pragma once

#include <array>

#include "ir/op.h"

namespace wrinkle {

// By SurfaceInput; -1: computed in the shader, without an attribute.
inline constexpr std::array<int, surface_input_count> attribute_locations = {0, 1, 2, 3,  4,
                                                                             5, 6, 7, -1, -1};
inline constexpr int attribute_count = 8;  // the locations from here on are free

constexpr int location_of(SurfaceInput input) {
    return attribute_locations[static_cast<size_t>(input)];
}

}  // namespace wrinkle
