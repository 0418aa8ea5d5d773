// Constant folding in double by the semantics documented above the op table, bit-identical on every
// machine.
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

// Returns false if the op has no constant result (leaves, textures, regions, opaque ops) or if an
// operand is outside its domain; the instruction is then not folded.
bool fold(Op op, Type result, uint32_t extra, std::span<const Constant> operands, Lanes& lanes);

}  // namespace wrinkle
