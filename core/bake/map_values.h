// Builds the expressions of maps as additional values of a material's module. Part of plan_maps().
#pragma once

#include "ir/value.h"

namespace wrinkle {

// Returns the normal in the tangent frame: m with normal ~ m.x T + m.y B + m.z N, unit; (0, 0, 1)
// if the volume of the frame is zero.
Value in_tangent_space(Module& module, Value normal, bool vertex_tangents);

// Returns (dh/dx, dh/dy): the differential, per texel, of the height with this normal.
Value slope_of_normal(Module& module, Value normal);

}  // namespace wrinkle
