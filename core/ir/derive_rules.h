// The derivative of each op, operand by operand. Part of derive.
#pragma once

#include <span>

#include "ir/module.h"

namespace wrinkle {

// The tangent of instruction `id` from those of its operands (poison: zero; at least one is not),
// of the instruction's type. Not for textures, calls and loops.
Id tangent_of_op(Module& module, Id id, std::span<const Id> tangents);

}  // namespace wrinkle
