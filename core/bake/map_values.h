// The expressions of maps, as further values of a material's module. Part of plan_maps().
#pragma once

#include "ir/value.h"

namespace wrinkle {

// A normal in the frame of the surface's tangents: m with normal ~ m.x T + m.y B + m.z N, unit;
// (0, 0, 1) where the frame has no volume.
Value in_tangent_space(Module& module, Value normal, bool vertex_tangents);

// (dh/dx, dh/dy): the change to the next texel of the height whose bump makes this normal.
Value slope_of_normal(Module& module, Value normal);

}  // namespace wrinkle
