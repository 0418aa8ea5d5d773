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
    bool is_op = false;
    bool host_only = false;
    bool detailed = false;  // `extra` says something
    bool implicit = false;
};
inline constexpr auto emissions = [] {
    std::array<Emission, tables::op_count + 1> table{};  // the last: an op that there is not
    for (size_t i = 0; i < tables::op_count; ++i) {
        const auto op = static_cast<Op>(i);
        const OpInfo& row = info(op);
        table[i] = {!row.name.empty(), host_only(op), has_detail(op),
                    (row.flags & WR_FLAG_IMPLICIT) != 0};
    }
    return table;
}();

}  // namespace wrinkle
