// Human-readable form of a module: one line per instruction that the outputs need, in id order.
//   %7 vec3 = mul %5 %6  ; weave
// and, before its first use, one line per region: the types of its parameters, and its results.
//   @2 function noise (vec2, float) -> %4
#pragma once

#include <string>

#include "ir/module.h"

namespace wrinkle {

std::string print(const Module& module);

}  // namespace wrinkle
