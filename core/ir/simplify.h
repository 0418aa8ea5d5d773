// Peephole simplification: an instruction that equals a simpler value is not written.
#pragma once

#include <span>

#include "ir/module.h"

namespace wrinkle {

// Returns an existing or simpler value equal to this instruction; poison if there is none.
// Precondition: types are checked. Inspects literals only, never the values of the user's
// parameters.
Id simplified(Module& module, Op op, std::span<const Id> args, uint32_t extra, Type result);

}  // namespace wrinkle
