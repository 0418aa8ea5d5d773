// Numbers of all kernels that a step may use: one for each op and type of operands, one for each
// fused pair of ops. compile_program() stores the number in the step; each instruction set has a
// table of its kernels.
//
// A pair is out = second(first(a, b), c), or second(c, first(a, b)) if swapped. Each op rounds
// separately.
#pragma once

#include <algorithm>
#include <array>

#include "cpu/evaluate.h"
#include "ir/op.h"

namespace wrinkle {

inline constexpr std::array first_ops = {Op::abs_, Op::add_, Op::sub_,
                                         Op::mul_, Op::min_, Op::max_};
inline constexpr std::array second_ops = {Op::add_, Op::sub_, Op::mul_, Op::min_, Op::max_};

inline constexpr size_t first_pair = 3 * tables::op_count;
inline constexpr size_t kernel_count = first_pair + first_ops.size() * second_ops.size() * 2;

template <size_t count>
constexpr size_t index_in(const std::array<Op, count>& ops, Op op) {
    return static_cast<size_t>(std::find(ops.begin(), ops.end(), op) - ops.begin());
}
template <size_t count>
constexpr bool stands_in(const std::array<Op, count>& ops, Op op) {
    return index_in(ops, op) < count;
}

// Operands are float, int, or uint and bool.
constexpr size_t op_kernel(Op op, Type type) {
    const size_t column = type == Type::float_ ? 0 : type == Type::int_ ? 1 : 2;
    return column * tables::op_count + static_cast<size_t>(op);
}
constexpr size_t fused_kernel(Op first, Op second, bool swapped) {
    const size_t row = index_in(first_ops, first) * second_ops.size();
    return first_pair + (row + index_in(second_ops, second)) * 2 + (swapped ? 1 : 0);
}

inline size_t kernel_index(const CpuInst& step) {
    return step.kind == CpuInst::Kind::pair ? fused_kernel(step.op, step.second, step.swapped)
                                            : op_kernel(step.op, step.type);
}

}  // namespace wrinkle
