// What an op that a plugin emits is looked at for, by its number. For core/lower alone.
#pragma once

#include "ir/op.h"

namespace wrinkle {

constexpr bool is_sampling(Op op) {
    return op == Op::sample_ || op == Op::sample_lod_ || op == Op::sample_grad_ ||
           op == Op::image_size_;
}
constexpr bool host_only(Op op) {
    return info(op).rule == Rule::leaf || op == Op::loop_ || op == Op::call_ || op == Op::result_ ||
           is_sampling(op);
}
constexpr bool is_gradient_source(Op op) {
    return (op >= Op::gradient_from_derivative_ && op <= Op::gradient_from_normal_) ||
           op == Op::gradient_from_outward_normal_;
}
constexpr bool has_detail(Op op) {
    return op == Op::swizzle_ || op == Op::column_ || op == Op::resolve_ || op == Op::frame_ ||
           is_gradient_source(op);
}

// What a plugin's number of an op is looked at for, all ops in one table.
struct Emission {
    uint8_t least = 0, end = 0;  // operands: as many as least, fewer than end; host's: none fit
    bool detailed = false;       // `extra` says something
    bool implicit = false;
};
inline constexpr auto emissions = [] {
    constexpr int8_t most_operands = 4;
    std::array<Emission, tables::op_count + 1> table{};  // the last: an op that there is not
    for (size_t i = 0; i < tables::op_count; ++i) {
        const auto op = static_cast<Op>(i);
        const OpInfo& row = info(op);
        if (row.name.empty() || host_only(op)) continue;
        const bool variadic = row.arity < 0;
        table[i].least = static_cast<uint8_t>(variadic ? 1 : row.arity);
        table[i].end = static_cast<uint8_t>((variadic ? most_operands : row.arity) + 1);
        table[i].detailed = has_detail(op);
        table[i].implicit = (row.flags & WR_FLAG_IMPLICIT) != 0;
    }
    return table;
}();

}  // namespace wrinkle
