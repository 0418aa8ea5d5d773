// A module as text, and the check of its invariants.
#pragma once

#include <string>

#include "ir/module.h"

namespace wrinkle {

// Returns one line per instruction that the outputs need, in id order,
//   %7 vec3 = mul %5 %6  ; weave
// and, before its first use, one line per region: the types of its parameters, and its results.
//   @2 function noise (vec2, float) -> %4
std::string print(const Module& module);

// Checks operand order, types, levels, closed regions, and that no region has an implicit
// derivative. Returns "" if the module is valid, else a message for the first violation, which is a
// compiler bug; tests and debug builds call this after every pass.
std::string verify(const Module& module);

}  // namespace wrinkle
