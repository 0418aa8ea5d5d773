// Constants, computed in double by the semantics written above the op table, to the same bits on
// every machine.
#pragma once

#include <array>
#include <span>

#include "ir/op.h"

namespace wrinkle {

using Lanes = std::array<double, 9>;
struct Constant {
    Type type;
    Lanes lanes;
};

// False where the op has no constant result (leaves, textures, regions, opaque ops) or an operand
// lies outside its domain; such an instruction stays as written.
bool fold(Op op, Type result, uint32_t extra, std::span<const Constant> operands, Lanes& lanes);

}  // namespace wrinkle
