// Which types an op takes and gives: the rules named in the op table, and the special ones.
#pragma once

#include <span>
#include <string>

#include "ir/op.h"

namespace wrinkle {

// The result's type, or poison with the reason in `why`, if it is asked for ("mul takes float or
// vector types, not bool"). `wanted` is the type that construct and result are told to make; of a
// swizzle it is the caller's reading of its components.
Type result_type(Op op, std::span<const Type> operands, Type wanted, std::string* why);

}  // namespace wrinkle
