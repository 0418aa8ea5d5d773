// Numbers of all kernels that a step may use: one for each op and type of operands, for each fused
// pair of ops, for each move, and for hashes. compile_program() stores the number in the step; each
// instruction set has a table of its kernels.
//
// A pair is out = second(first(a, b), c), or second(c, first(a, b)) if swapped. Each op rounds
// separately.
#pragma once

#include <algorithm>
#include <array>

#include "cpu/evaluate.h"
#include "ir/op.h"

namespace wrinkle {

inline constexpr std::array first_ops = {Op::abs_, Op::add_, Op::sub_,     Op::mul_,
                                         Op::min_, Op::max_, Op::to_float_};  // from uint
inline constexpr std::array second_ops = {Op::add_, Op::sub_, Op::mul_, Op::min_, Op::max_};

inline constexpr std::array first_word_ops = {Op::add_, Op::mul_, Op::bit_and_, Op::bit_xor_,
                                              Op::shift_right_};
inline constexpr std::array second_word_ops = first_word_ops;

inline constexpr size_t first_pair = 3 * tables::op_count;
inline constexpr size_t first_word_pair = first_pair + first_ops.size() * second_ops.size() * 2;
inline constexpr size_t first_move =
    first_word_pair + first_word_ops.size() * second_word_ops.size() * 2;
inline constexpr size_t hash_kernel = first_move + 4;
inline constexpr size_t kernel_count = hash_kernel + 1;

// Constants of the PCG permutation (M. O'Neill 2014), which the SDK's hash() writes as integer ops.
struct PcgConstants {
    uint32_t multiplier = 747796405, increment = 2891336453;
    uint32_t shift = 28, least_shift = 4, factor = 277803737, last_shift = 22;
};

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
constexpr size_t fused_word_kernel(Op first, Op second, bool swapped) {
    const size_t row = index_in(first_word_ops, first) * second_word_ops.size();
    return first_word_pair + (row + index_in(second_word_ops, second)) * 2 + (swapped ? 1 : 0);
}
constexpr size_t move_kernel(Type type, bool masked) {
    return first_move + (type == Type::float_ ? 0 : 2) + (masked ? 1 : 0);
}

inline bool has_kernel(const CpuInst& step) {
    return step.kind == CpuInst::Kind::op || step.kind == CpuInst::Kind::pair ||
           step.kind == CpuInst::Kind::hash || step.kind == CpuInst::Kind::move ||
           step.kind == CpuInst::Kind::masked_move;
}

// Precondition: has_kernel(step).
inline size_t kernel_index(const CpuInst& step) {
    if (step.kind == CpuInst::Kind::hash) return hash_kernel;
    if (step.kind == CpuInst::Kind::op) return op_kernel(step.op, step.type);
    if (step.kind != CpuInst::Kind::pair)
        return move_kernel(step.type, step.kind == CpuInst::Kind::masked_move);
    return step.type == Type::float_ ? fused_kernel(step.op, step.second, step.swapped)
                                     : fused_word_kernel(step.op, step.second, step.swapped);
}

}  // namespace wrinkle
