// A module as text for people: one line per instruction that the outputs need, in id order.
//   %7 vec3 = mul %5 %6            ; node weave
#pragma once

#include <string>

#include "ir/module.h"

namespace wrinkle {

std::string print(const Module& module);

}  // namespace wrinkle
