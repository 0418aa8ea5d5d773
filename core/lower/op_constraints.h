// Constraints on an op that a plugin emits, by its number. Internal to core/lower.
#pragma once

#include "ir/op.h"

namespace wrinkle {

constexpr bool host_only(Op op) {
    return info(op).rule == Rule::leaf || op == Op::loop_ || op == Op::call_ || op == Op::result_ ||
           reads_image(op);
}
constexpr bool has_detail(Op op) {
    return op == Op::swizzle_ || op == Op::column_ || op == Op::resolve_ || op == Op::frame_ ||
           is_gradient_source(op);
}

// Constraints on an op emitted by a plugin; the table has all ops.
struct OpConstraints {
    uint8_t least = 0, end = 0;  // operand count in [least, end); empty for ops of the host only
    bool detailed = false;       // `extra` has a meaning
    bool implicit = false;
};
inline constexpr auto op_constraints = [] {
    constexpr int8_t max_operands = 4;
    std::array<OpConstraints, tables::op_count + 1> table{};  // the last entry: unknown ops
    for (size_t i = 0; i < tables::op_count; ++i) {
        const auto op = static_cast<Op>(i);
        const OpInfo& row = info(op);
        if (row.name.empty() || host_only(op)) continue;
        const bool variadic = row.arity < 0;
        table[i].least = static_cast<uint8_t>(variadic ? 1 : row.arity);
        table[i].end = static_cast<uint8_t>((variadic ? max_operands : row.arity) + 1);
        table[i].detailed = has_detail(op);
        table[i].implicit = (row.flags & WR_FLAG_IMPLICIT) != 0;
    }
    return table;
}();

}  // namespace wrinkle
