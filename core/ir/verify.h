// Checks that hold for every module: operand order, types, levels, regions closed, no implicit
// derivative inside a region. A violation is our bug; tests and debug builds call this after every
// pass.
#pragma once

#include <string>

#include "ir/module.h"

namespace wrinkle {

// "" when all is well, else the first violation in words.
std::string verify(const Module& module);

}  // namespace wrinkle
