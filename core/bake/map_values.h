// Builds the expressions of maps as additional values of a material's module. Part of plan_maps().
#pragma once

#include "ir/value.h"

namespace wrinkle {

// Returns (dh/dx, dh/dy): the differential, per texel, of the height with this normal.
Value slope_of_normal(Module& module, Value normal);

}  // namespace wrinkle
