// Operand and result types of ops: the rules named in the op table, and the special ones.
#pragma once

#include <span>
#include <string>

#include "ir/op.h"

namespace wrinkle {

// Returns the result's type; poison on error, with the reason in `why` unless that is null ("mul
// takes float or vector types, not bool"). `wanted` is the requested type of construct and result;
// of a swizzle it is the type that the caller derived from its components.
Type result_type(Op op, std::span<const Type> operands, Type wanted, std::string* why);

}  // namespace wrinkle
