// JVP rule of each op. Part of ir/derive.h.
#pragma once

#include <span>

#include "ir/module.h"

namespace wrinkle {

// Returns the tangent of instruction `id`, of the instruction's type, from the tangents of its
// operands (poison: zero). Precondition: at least one is not zero; the instruction is not a texture
// sample, call or loop.
Id jvp_rule(Module& module, Id id, std::span<const Id> tangents);

}  // namespace wrinkle
