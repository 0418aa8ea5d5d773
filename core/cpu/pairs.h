// Two ops that are done in one pass over memory: out = second(first(a, b), c), or
// second(c, first(a, b)) where they are swapped. Each rounds by itself.
#pragma once

#include <algorithm>
#include <array>

#include "ir/op.h"

namespace wrinkle {

inline constexpr std::array first_ops = {Op::abs_, Op::add_, Op::sub_,
                                         Op::mul_, Op::min_, Op::max_};
inline constexpr std::array second_ops = {Op::add_, Op::sub_, Op::mul_, Op::min_, Op::max_};
inline constexpr size_t pair_count = first_ops.size() * second_ops.size() * 2;

template <size_t count>
constexpr size_t index_in(const std::array<Op, count>& ops, Op op) {
    return static_cast<size_t>(std::find(ops.begin(), ops.end(), op) - ops.begin());
}
template <size_t count>
constexpr bool stands_in(const std::array<Op, count>& ops, Op op) {
    return index_in(ops, op) < count;
}

// Below pair_count.
constexpr size_t pair_place(Op first, Op second, bool swapped) {
    return (index_in(first_ops, first) * second_ops.size() + index_in(second_ops, second)) * 2 +
           (swapped ? 1 : 0);
}

}  // namespace wrinkle
