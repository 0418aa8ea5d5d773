// Checks the invariants of a module: operand order, types, levels, closed regions, no implicit
// derivative inside a region. A violation is a compiler bug; tests and debug builds call this after
// every pass.
#pragma once

#include <string>

#include "ir/module.h"

namespace wrinkle {

// Returns "" if the module is valid, else a message for the first violation.
std::string verify(const Module& module);

}  // namespace wrinkle
