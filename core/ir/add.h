// The steps of Module::add(): the result's type, constant folding, simplification.
#pragma once

#include <array>
#include <span>
#include <string>

#include "ir/inst.h"

namespace wrinkle {

class Module;

// Returns the result's type; poison on error, with the reason in `why` unless that is null ("mul
// takes float or vector types, not bool"). `wanted` is the requested type of construct and result;
// of a swizzle it is the type that the caller derived from its components.
Type result_type(Op op, std::span<const Type> operands, Type wanted, std::string* why);

// Components of a vector, columns of a mat3.
using Lanes = std::array<double, 9>;
struct Constant {
    Type type;
    Lanes lanes;
};

// Folds constants in double by the semantics documented above the op table, bit-identical on every
// machine. Returns false if the op has no constant result (leaves, textures, regions, opaque ops)
// or if an operand is outside its domain; the instruction is then not folded.
bool fold(Op op, Type result, uint32_t extra, std::span<const Constant> operands, Lanes& lanes);

// Returns an existing or simpler value equal to this instruction; no_id if there is none.
// Precondition: types are checked. Inspects literals only, never the values of the user's
// parameters.
Id simplified(Module& module, Op op, std::span<const Id> args, uint32_t extra, Type result);

}  // namespace wrinkle
