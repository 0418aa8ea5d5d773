#include "ir/add.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/module.h"

namespace wrinkle {
namespace {

using Args = std::span<const Id>;

// `value` converted to the type: a float combined with a vector is broadcast.
Id widened(Module& m, Id value, Type type) {
    if (m.type(value) == type) return value;
    std::array<Id, 4> lanes{value, value, value, value};
    return m.add(Op::construct_, std::span(lanes.data(), info(type).lanes), 0, type);
}

// A lower bound of a scalar by the form of its expression, one op deep (two below a sqrt).
double min_of(const Module& m, Id id, bool under_root = false) {
    const Inst& inst = m[id];
    const auto literal = [&](Id operand) {
        return m[operand].op == Op::literal_ ? m[operand].value
                                             : -std::numeric_limits<double>::infinity();
    };
    switch (inst.op) {
        case Op::literal_:
            return inst.value;
        case Op::max_:
            return std::max(literal(inst.arg[0]), literal(inst.arg[1]));
        case Op::swizzle_: {  // a component of max(v, constant)
            const Inst& vector = m[inst.arg[0]];
            if (vector.op != Op::max_ || inst.type != Type::float_ || !m.is_constant(vector.arg[1]))
                return -std::numeric_limits<double>::infinity();
            return m.lanes_of(vector.arg[1])[static_cast<size_t>(swizzle_component(inst.extra, 0))];
        }
        case Op::sqrt_:
            return under_root ? 0 : std::sqrt(std::max(min_of(m, inst.arg[0], true), 0.0));
        case Op::dot_:
        case Op::mul_:
            return inst.arg[0] == inst.arg[1] ? 0 : -std::numeric_limits<double>::infinity();
        case Op::abs_:
        case Op::length_:
            return 0;
        default:
            return -std::numeric_limits<double>::infinity();
    }
}

// Returns x * y for -x * y, and x * 2 for x * -2; no_id for any other value.
Id without_sign(Module& m, Id id) {
    const Inst product = m[id];
    if (product.op != Op::mul_) return no_id;
    const auto [a, b] = std::pair(product.arg[0], product.arg[1]);
    if (m[a].op == Op::neg_) return m.add(Op::mul_, {m[a].arg[0], b});
    const bool negative = m[b].op == Op::literal_ && m[b].type == Type::float_ && m[b].value < 0;
    return negative ? m.add(Op::mul_, {a, m.number(-m[b].value)}) : no_id;
}

Id simplify_sum(Module& m, Op op, Args a, Type type) {
    if (m.is_literal(a[1], 0)) return widened(m, a[0], type);
    if (op == Op::add_) {
        if (m.is_literal(a[0], 0)) return widened(m, a[1], type);
        if (m[a[1]].op == Op::neg_) return m.add(Op::sub_, {a[0], m[a[1]].arg[0]});
        const Id taken = without_sign(m, a[1]);
        return taken == no_id ? no_id : m.add(Op::sub_, {a[0], taken});
    }
    if (a[0] == a[1]) return m.zero(type);
    if (m.is_literal(a[0], 0) && m.type(a[1]) == type) return m.add(Op::neg_, {a[1]});
    if (m[a[1]].op == Op::neg_) return m.add(Op::add_, {a[0], m[a[1]].arg[0]});
    const Inst& taken = m[a[1]];
    if (taken.op == Op::literal_ && taken.type == Type::float_ && taken.value < 0)
        return m.add(Op::add_, {a[0], m.number(-taken.value)});
    const Id added = without_sign(m, a[1]);
    return added == no_id ? no_id : m.add(Op::add_, {a[0], added});
}

// Returns true for 1, which a product of scales may miss by a bit: 49 * (1 / 49).
bool is_one(const Module& m, Id id) {
    return m[id].op == Op::literal_ ? std::abs(m[id].value - 1) < 1e-15 : m.is_literal(id, 1);
}

Id simplify_product(Module& m, Args a, Type type) {
    for (const size_t i : {0u, 1u}) {
        if (m.is_literal(a[i], 0)) return m.zero(type);
        if (is_one(m, a[i])) return widened(m, a[1 - i], type);
        if (m.is_literal(a[i], -1) && m.type(a[1 - i]) == type) return m.add(Op::neg_, {a[1 - i]});
    }
    return no_id;
}

// Returns true for a vector of floats with a component that simplifies the op: 0, for a product 1
// and -1 too.
bool is_sparse(const Module& m, Op op, Id id) {
    if (m[id].op != Op::construct_ || m[id].type == Type::mat3_) return false;
    bool found = false;
    for (const Id part : m.operands(id)) {
        if (m.type(part) != Type::float_) return false;
        found = found || m.is_literal(part, 0) ||
                (op == Op::mul_ && (is_one(m, part) || m.is_literal(part, -1)));
    }
    return found;
}

// -vec2(x, 0) is vec2(-x, 0).
Id negated_parts(Module& m, Id vector, Type type) {
    std::array<Id, 4> lanes{};
    const uint32_t count = info(type).lanes;
    for (uint32_t i = 0; i < count; ++i) {
        const Id lane = m.component(vector, i);
        lanes[i] = m.is_literal(lane, 0) ? lane : m.add(Op::neg_, {lane});
    }
    return m.add(Op::construct_, std::span(lanes.data(), count), 0, type);
}

// Returns v if the test is dot(v, v) > 0 or length(v) > 0; otherwise no_id.
Id tested_for_length(const Module& m, Id test) {
    const Inst& inst = m[test];
    if (inst.op != Op::gt_ || !m.is_literal(inst.arg[1], 0)) return no_id;
    const Inst& size = m[inst.arg[0]];
    const bool square = size.op == Op::dot_ && size.arg[0] == size.arg[1];
    return square || size.op == Op::length_ ? size.arg[0] : no_id;
}

// Returns p ? a : b for p ? (q ? a : b) : b, if p and q are one test of a vector's length: the
// derivative of a guarded normalize. Returns v for dot(v, v) > 0 ? v : 0.
Id simplify_test_of_length(Module& m, Args a) {
    const Id vector = tested_for_length(m, a[0]);
    if (vector == no_id) return no_id;
    if (a[1] == vector && m.is_literal(a[2], 0)) return vector;
    const Inst inner = m[a[1]];
    const bool twice = inner.op == Op::select_ && inner.arg[2] == a[2] &&
                       tested_for_length(m, inner.arg[0]) == vector;
    return twice ? m.add(Op::select_, {a[0], inner.arg[1], a[2]}) : no_id;
}

Id simplify_arithmetic(Module& m, Op op, Args a, Type type) {
    switch (op) {
        case Op::neg_:
            if (m[a[0]].op == Op::neg_) return m[a[0]].arg[0];
            if (is_sparse(m, op, a[0])) return negated_parts(m, a[0], type);
            if (m[a[0]].op == Op::sub_ && m.type(m[a[0]].arg[0]) == m.type(m[a[0]].arg[1]))
                return m.add(Op::sub_, {m[a[0]].arg[1], m[a[0]].arg[0]});
            return no_id;
        case Op::add_:
        case Op::sub_:
            return simplify_sum(m, op, a, type);
        case Op::mul_:
            return simplify_product(m, a, type);
        case Op::div_:
            if (m.is_literal(a[1], 1)) return widened(m, a[0], type);
            return m.is_literal(a[0], 0) ? m.zero(type) : no_id;
        case Op::min_:
            return a[0] == a[1] ? a[0] : no_id;
        case Op::max_:
            if (a[0] == a[1]) return a[0];
            if (!is_float_type(type) || m[a[1]].op != Op::literal_) return no_id;
            return min_of(m, a[0]) >= m[a[1]].value ? a[0] : no_id;
        case Op::mix_:
            if (a[0] == a[1] || m.is_literal(a[2], 0)) return widened(m, a[0], type);
            if (m.is_literal(a[0], 0)) return m.add(Op::mul_, {a[1], a[2]});
            return m.is_literal(a[2], 1) ? widened(m, a[1], type) : no_id;
        case Op::abs_:
            return m[a[0]].op == op ? a[0] : no_id;
        case Op::cross_:
            if (a[0] == a[1]) return m.zero(type);
            [[fallthrough]];
        case Op::dot_:
            return m.is_literal(a[0], 0) || m.is_literal(a[1], 0) ? m.zero(type) : no_id;
        case Op::select_:
            if (a[1] == a[2]) return a[1];
            if (m[a[0]].op == Op::literal_) return m[a[0]].value != 0 ? a[1] : a[2];
            return simplify_test_of_length(m, a);
        case Op::not_:
            return m[a[0]].op == Op::not_ ? m[a[0]].arg[0] : no_id;
        case Op::and_:
        case Op::or_: {
            const bool absorbing = op == Op::or_;
            for (const size_t i : {0u, 1u})
                if (m[a[i]].op == Op::literal_)
                    return (m[a[i]].value != 0) == absorbing ? a[i] : a[1 - i];
            return a[0] == a[1] ? a[0] : no_id;
        }
        case Op::detach_:
            return m.is_constant(a[0]) || m[a[0]].op == Op::detach_ || m[a[0]].op == Op::parameter_
                       ? a[0]
                       : no_id;
        default:
            return no_id;
    }
}

bool is_facing(const Module& m, Id id) {
    return m[id].op == Op::input_ && input_of(m[id].extra) == SurfaceInput::facing_;
}

// Returns true if the value has length 1 by the form of its expression, up to four ops deep. A
// normalized zero vector is undefined anyway.
bool is_unit(const Module& m, Id id) {
    for (int looks = 0; looks < 4; ++looks) {
        const Inst& inst = m[id];
        if (inst.op == Op::normalize_ || inst.op == Op::resolve_) return true;
        const bool turned = inst.op == Op::mul_ && is_facing(m, inst.arg[1]);
        if (!turned && inst.op != Op::detach_ && inst.op != Op::neg_) return false;
        id = inst.arg[0];
    }
    return false;
}

// Returns true for a guarded normalize: p ? unit : 0.
bool is_unit_or_zero(const Module& m, Id id) {
    const Inst& inst = m[id];
    return inst.op == Op::select_ && is_unit(m, inst.arg[1]) && m.is_literal(inst.arg[2], 0);
}

// Simplifications by unit length and by `facing`, which is +1 or -1; they remove guards of normals.
Id simplify_unit(Module& m, Op op, Args a) {
    switch (op) {
        case Op::normalize_:
            return is_unit(m, a[0]) || is_unit_or_zero(m, a[0]) ? a[0] : no_id;
        case Op::length_:
            return is_unit(m, a[0]) ? m.number(1) : no_id;
        case Op::dot_:
            if (a[0] == a[1]) return is_unit(m, a[0]) ? m.number(1) : no_id;
            for (const size_t i : {0u, 1u}) {
                const Inst& turned = m[a[i]];
                if (turned.op == Op::mul_ && turned.arg[0] == a[1 - i] &&
                    is_facing(m, turned.arg[1]) && is_unit(m, a[1 - i]))
                    return turned.arg[1];
            }
            return no_id;
        case Op::sign_nonzero_:
            return is_facing(m, a[0]) ? a[0] : no_id;
        case Op::mul_:
            if (is_facing(m, a[1]) && m[a[0]].op == Op::mul_ && m[a[0]].arg[1] == a[1])
                return m[a[0]].arg[0];
            return no_id;
        case Op::abs_:
            return m[a[0]].op == Op::mul_ && is_facing(m, m[a[0]].arg[1])
                       ? m.add(Op::abs_, {m[a[0]].arg[0]})
                       : no_id;
        default:
            return no_id;
    }
}

// Tests that always hold, as max(x, 1) > 0.
Id simplify_greater(Module& m, Args a) {
    if (m.type(a[0]) != Type::float_ || m[a[1]].op != Op::literal_) return no_id;
    return min_of(m, a[0]) > m[a[1]].value ? m.literal(Type::bool_, 1) : no_id;
}

// Small integer powers become products; pow is undefined below 0.
Id simplify_power(Module& m, Args a) {
    if (m.is_constant(a[0])) return no_id;
    const Id base = a[0];
    if (m.is_literal(a[1], 1)) return base;
    const Id square = m.add(Op::mul_, {base, base});
    if (m.is_literal(a[1], 2)) return square;
    if (m.is_literal(a[1], 3)) return m.add(Op::mul_, {square, base});
    return m.is_literal(a[1], 4) ? m.add(Op::mul_, {square, square}) : no_id;
}

// Returns a component of a construct; no_id if its parts have fewer.
Id lane_of_construct(Module& m, Id construct, int lane) {
    for (const Id part : m.operands(construct)) {
        const int lanes = info(m.type(part)).lanes;
        if (lane < lanes) return m.component(part, static_cast<uint32_t>(lane));
        lane -= lanes;
    }
    return no_id;
}

Id simplify_swizzle(Module& m, Id vector, uint32_t extra, Type type) {
    const int count = swizzle_count(extra);
    bool whole = m.type(vector) == type;
    for (int i = 0; i < count; ++i)
        whole = whole && swizzle_component(extra, i) == i;
    if (whole) return vector;
    const Inst inner = m[vector];
    if (inner.op == Op::swizzle_) {
        auto composed = static_cast<uint32_t>(count);
        for (int i = 0; i < count; ++i)
            composed |=
                swizzle_lane(swizzle_component(inner.extra, swizzle_component(extra, i)), i);
        return m.add(Op::swizzle_, {inner.arg[0]}, composed);
    }
    if (inner.op != Op::construct_) return no_id;
    std::array<Id, 4> lanes{};
    for (int i = 0; i < count; ++i) {
        Id& lane = lanes[static_cast<size_t>(i)];
        lane = lane_of_construct(m, vector, swizzle_component(extra, i));
        if (lane == no_id) return no_id;
    }
    if (count == 1) return lanes[0];
    return m.add(Op::construct_, std::span(lanes.data(), static_cast<size_t>(count)), 0, type);
}

// Flattens nested constructs; components that are all taken from one vector become a swizzle of it.
Id simplify_construct(Module& m, Args parts, Type type) {
    if (type == Type::mat3_) return no_id;
    if (parts.size() == 1) return parts[0];
    std::array<Id, 4> flat{};
    size_t count = 0;
    for (const Id part : parts) {
        if (m[part].op == Op::construct_)
            for (const Id inner : m.operands(part))
                flat[count++] = inner;
        else
            flat[count++] = part;
    }
    if (count > parts.size()) return m.add(Op::construct_, std::span(flat.data(), count), 0, type);
    Id vector = no_id;
    uint32_t extra = 0;
    int lane = 0;
    for (const Id part : parts) {
        const Inst& inst = m[part];
        if (inst.op != Op::swizzle_ || (vector && inst.arg[0] != vector)) return no_id;
        vector = inst.arg[0];
        for (int i = 0; i < swizzle_count(inst.extra); ++i)
            extra |= swizzle_lane(swizzle_component(inst.extra, i), lane++);
    }
    return m.add(Op::swizzle_, {vector}, extra | static_cast<uint32_t>(lane));
}

// Applies the op by components if that removes some: vec2(x, 0) * s is vec2(x * s, 0).
Id simplify_sparse(Module& m, Op op, Args args, Type type) {
    if (op != Op::add_ && op != Op::sub_ && op != Op::mul_ && op != Op::dot_) return no_id;
    const Id a = args[0], b = args[1];
    const Op lane_op = op == Op::dot_ ? Op::mul_ : op;
    if (info(m.type(a)).lanes < 2 && info(m.type(b)).lanes < 2) return no_id;
    if (!is_sparse(m, lane_op, a) && !is_sparse(m, lane_op, b)) return no_id;
    const uint32_t count = std::max(info(m.type(a)).lanes, info(m.type(b)).lanes);
    std::array<Id, 4> lanes{};
    for (uint32_t i = 0; i < count; ++i)
        lanes[i] = m.add(lane_op, {m.component(a, i), m.component(b, i)});
    if (op != Op::dot_) return m.add(Op::construct_, std::span(lanes.data(), count), 0, type);
    Id sum = lanes[0];
    for (uint32_t i = 1; i < count; ++i)
        sum = m.add(Op::add_, {sum, lanes[i]});
    return sum;
}

Id simplify_gradient(Module& m, Op op, Args a) {
    const auto flat = [&](Id id) { return m[id].op == Op::gradient_zero_; };
    // Flat on any base, or on that of the other gradient: a flat gradient retains its base, as one
    // scaled by a parameter does.
    const auto nothing_beside = [&](Id id, Id other) {
        return flat(id) && (m[id].extra == no_id || m[id].extra == m[other].extra);
    };
    switch (op) {
        case Op::gradient_add_:
            return nothing_beside(a[0], a[1]) ? a[1] : nothing_beside(a[1], a[0]) ? a[0] : no_id;
        case Op::gradient_scale_:
            if (flat(a[0]) || m.is_literal(a[1], 1)) return a[0];
            if (m.is_literal(a[1], 0)) return m.add(Op::gradient_zero_, {}, m[a[0]].extra);
            if (m[a[0]].op == Op::gradient_scale_) {
                const Inst inner = m[a[0]];
                return m.add(Op::gradient_scale_,
                             {inner.arg[0], m.add(Op::mul_, {inner.arg[1], a[1]})});
            }
            return no_id;
        case Op::gradient_mix_:
            if (a[0] == a[1]) return a[0];
            if (nothing_beside(a[0], a[1])) return m.add(Op::gradient_scale_, {a[1], a[2]});
            if (nothing_beside(a[1], a[0]))
                return m.add(Op::gradient_scale_, {a[0], m.add(Op::sub_, {m.number(1), a[2]})});
            if (m[a[0]].extra != m[a[1]].extra) return no_id;
            return m.is_literal(a[2], 0) ? a[0] : m.is_literal(a[2], 1) ? a[1] : no_id;
        default:
            return no_id;
    }
}

}  // namespace

Id simplified(Module& m, Op op, Args args, uint32_t extra, Type result) {
    switch (op) {
        case Op::swizzle_:
            return simplify_swizzle(m, args[0], extra, result);
        case Op::construct_:
            return simplify_construct(m, args, result);
        case Op::column_:
            return m[args[0]].op == Op::construct_ ? m[args[0]].arg[extra] : no_id;
        case Op::pow_:
            return simplify_power(m, args);
        case Op::gt_:
            return simplify_greater(m, args);
        default:
            break;
    }
    if (result == Type::gradient_) return simplify_gradient(m, op, args);
    if (const Id simpler = simplify_arithmetic(m, op, args, result)) return simpler;
    if (const Id simpler = simplify_unit(m, op, args)) return simpler;
    return result != Type::float_ || op == Op::dot_ ? simplify_sparse(m, op, args, result) : no_id;
}

}  // namespace wrinkle
