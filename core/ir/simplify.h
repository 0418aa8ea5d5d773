// Peepholes: an instruction that equals something simpler is never written.
#pragma once

#include <span>

#include "ir/module.h"

namespace wrinkle {

// An existing or simpler value equal to this instruction, or poison where there is none. Types are
// already checked. Looks at literals only, never at the values of the user's parameters.
Id simplified(Module& module, Op op, std::span<const Id> args, uint32_t extra, Type result);

}  // namespace wrinkle
