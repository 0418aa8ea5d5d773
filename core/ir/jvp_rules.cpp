#include "ir/derive.h"

#include <cassert>
#include <numbers>

#include "ir/value.h"

namespace wrinkle {
namespace {

// The operands of one instruction and their tangents; an empty tangent is zero.
struct Operands {
    Module* m;
    Value r;        // the instruction's own value
    Value a, b, c;  // operands
    Value ta, tb, tc;
};

Value constant(const Operands& x, double value) {
    return {x.m, x.m->number(value)};
}

Value sum(Value a, Value b) {
    if (!a || !b || a.module->type(a.id) != Type::mat3_) return sum_of(a, b);
    Module& m = *a.module;
    std::array<Id, 3> columns{};
    for (uint32_t k = 0; k < 3; ++k)
        columns[k] =
            m.add(Op::add_, {m.add(Op::column_, {a.id}, k), m.add(Op::column_, {b.id}, k)});
    return {&m, m.add(Op::construct_, columns, 0, Type::mat3_)};
}
Value difference(Value a, Value b) {
    if (!b) return a;
    return a ? a - b : -b;
}
Value transformed(Op o, Value a, Value b) {
    return a && b ? op(o, a, b) : Value{};
}

Value or_zero(const Operands& x, Value tangent, Value like) {
    return tangent ? tangent : Value{x.m, x.m->zero(x.m->type(like.id))};
}

// One component of a value; a float is broadcast.
Value lane(Value v, uint32_t k) {
    return {v.module, v.module->component(v.id, k)};
}

// choose(k) returns component k of the result.
template <class Choose>
Value by_lanes(const Operands& x, Choose choose) {
    const Type type = x.m->type(x.r.id);
    std::array<Id, 4> lanes{};
    const uint32_t count = info(type).lanes;
    for (uint32_t k = 0; k < count; ++k)
        lanes[k] = choose(k).id;
    if (count == 1) return {x.m, lanes[0]};
    return {x.m, x.m->add(Op::construct_, std::span(lanes.data(), count), 0, type)};
}

// `value` if `test` > 0, else 0, per component.
Value where_positive(const Operands& x, Value test, Value value) {
    return by_lanes(x, [&](uint32_t k) {
        return select(greater(lane(test, k), 0), lane(value, k), constant(x, 0));
    });
}

// `second` if `low` < `high`, else `first`, per component; both are tangents.
Value smaller_wins(const Operands& x, Value low, Value high, Value second, Value first) {
    return by_lanes(x, [&](uint32_t k) {
        return select(op(Op::lt_, lane(low, k), lane(high, k)), lane(second, k), lane(first, k));
    });
}

// Between constant limits the derivative is that of `a`, beyond them zero.
Value derive_constant_clamp(const Operands& x) {
    return by_lanes(x, [&](uint32_t k) {
        const Value below = op(Op::lt_, lane(x.a, k), lane(x.b, k));
        const Value above = op(Op::lt_, lane(x.c, k), lane(x.a, k));
        return select(op(Op::or_, below, above), constant(x, 0), lane(x.ta, k));
    });
}

Value derive_clamp(const Operands& x) {
    const bool constant_limits = x.m->is_constant(x.b.id) && x.m->is_constant(x.c.id);
    if (constant_limits && x.ta) return derive_constant_clamp(x);
    const Value ta = or_zero(x, x.ta, x.a), tb = or_zero(x, x.tb, x.b), tc = or_zero(x, x.tc, x.c);
    const Value inner = max(x.a, x.b);
    return by_lanes(x, [&](uint32_t k) {
        const Value low = select(op(Op::lt_, lane(x.a, k), lane(x.b, k)), lane(tb, k), lane(ta, k));
        return select(op(Op::lt_, lane(x.c, k), lane(inner, k)), lane(tc, k), low);
    });
}

// t = clamp((x - e0) / (e1 - e0), 0, 1): 6 t (1 - t) t'.
Value derive_smoothstep(const Operands& x) {
    const Value width = x.b - x.a;
    const Value t = named("t", op(Op::clamp_, (x.c - x.a) / width, constant(x, 0), constant(x, 1)));
    const Value dwidth = difference(x.tb, x.ta);
    const Value derivative = difference(difference(x.tc, x.ta), product_of(dwidth, t));
    return derivative * (t * (constant(x, 1) - t) * 6) / width;
}

Value derive_arithmetic(const Operands& x, Op o) {
    switch (o) {
        case Op::neg_:
            return -x.ta;
        case Op::add_:
            return sum(x.ta, x.tb);
        case Op::sub_:
            return difference(x.ta, x.tb);
        case Op::mul_:
            if (x.a.id == x.b.id) return x.ta * x.a * 2;
            return sum(product_of(x.ta, x.b), product_of(x.tb, x.a));
        case Op::div_:
            return difference(x.ta, product_of(x.tb, x.r)) / x.b;
        case Op::mod_:
            return difference(x.ta, product_of(x.tb, op(Op::floor_, x.a / x.b)));
        case Op::abs_:
            return x.ta * op(Op::sign_, x.a);
        case Op::fract_:
            return x.ta;
        case Op::min_:
            return smaller_wins(x, x.b, x.a, or_zero(x, x.tb, x.b), or_zero(x, x.ta, x.a));
        case Op::max_:
            return smaller_wins(x, x.a, x.b, or_zero(x, x.tb, x.b), or_zero(x, x.ta, x.a));
        case Op::clamp_:
            return derive_clamp(x);
        case Op::mix_: {
            const Value ends = x.ta && x.tb ? op(Op::mix_, x.ta, x.tb, x.c)
                               : x.ta       ? x.ta * (constant(x, 1) - x.c)
                                            : product_of(x.tb, x.c);
            return sum(ends, product_of(x.tc, x.b - x.a));
        }
        case Op::smoothstep_:
            return derive_smoothstep(x);
        default:
            return {};
    }
}

Value derive_transcendental(const Operands& x, Op o) {
    const Value one = constant(x, 1);
    switch (o) {
        case Op::sqrt_:
            return x.ta * where_positive(x, x.r, constant(x, 0.5) / x.r);
        case Op::inversesqrt_:
            return x.ta * (x.r * x.r * x.r * -0.5);
        case Op::pow_:
            return sum(product_of(x.ta, where_positive(x, x.a, x.b * x.r / x.a)),
                       product_of(x.tb, where_positive(x, x.a, x.r * op(Op::log_, x.a))));
        case Op::exp_:
            return x.ta * x.r;
        case Op::log_:
            return x.ta / x.a;
        case Op::exp2_:
            return x.ta * (x.r * std::numbers::ln2);
        case Op::log2_:
            return x.ta / (x.a * std::numbers::ln2);
        case Op::sin_:
            return x.ta * op(Op::cos_, x.a);
        case Op::cos_:
            return -(x.ta * op(Op::sin_, x.a));
        case Op::tan_:
            return x.ta * (one + x.r * x.r);
        case Op::asin_:
        case Op::acos_: {
            const Value room = one - x.a * x.a;
            const Value slope = where_positive(x, room, inversesqrt(room));
            return o == Op::asin_ ? x.ta * slope : -(x.ta * slope);
        }
        case Op::atan_:
            return x.ta / (one + x.a * x.a);
        case Op::atan2_: {
            const Value square = x.a * x.a + x.b * x.b;
            const Value inverse = where_positive(x, square, one / square);
            return difference(product_of(x.ta, x.b), product_of(x.tb, x.a)) * inverse;
        }
        default:
            return {};
    }
}

Value derive_vector(const Operands& x, Op o) {
    switch (o) {
        case Op::dot_:
            if (x.a.id == x.b.id) return dot(x.a, x.ta) * 2;
            [[fallthrough]];
        case Op::cross_:
        case Op::transform_:
        case Op::matrix_product_:
            return sum(transformed(o, x.ta, x.b), transformed(o, x.a, x.tb));
        case Op::transpose_:
            return op(o, x.ta);
        case Op::length_:
            return select(greater(x.r, 0), dot(x.a, x.ta) / x.r, constant(x, 0));
        case Op::normalize_: {
            const Value length = op(Op::length_, x.a);
            const Value across = (x.ta - x.r * dot(x.r, x.ta)) / length;
            return select(greater(length, 0), across, or_zero(x, {}, x.r));
        }
        case Op::reflect_: {
            const Value turned =
                sum(transformed(Op::dot_, x.tb, x.a), transformed(Op::dot_, x.b, x.ta));
            const Value mirrored = sum(x.b * turned, product_of(x.tb, dot(x.b, x.a)));
            return difference(x.ta, mirrored * 2);
        }
        case Op::select_:
            return select(x.a, or_zero(x, x.tb, x.b), or_zero(x, x.tc, x.c));
        default:
            return {};
    }
}

Value derive_structure(const Operands& x, const Inst& inst, std::span<const Id> operands,
                       std::span<const Id> tangents) {
    if (inst.op == Op::swizzle_ || inst.op == Op::column_)
        return {x.m, x.m->add(inst.op, {x.ta.id}, inst.extra)};
    if (inst.op != Op::construct_) return {};
    std::array<Id, 4> parts{};
    for (size_t i = 0; i < operands.size(); ++i)
        parts[i] = tangents[i] ? tangents[i] : x.m->zero(x.m->type(operands[i]));
    return {x.m, x.m->add(Op::construct_, std::span(parts.data(), operands.size()), 0, inst.type)};
}

}  // namespace

Id jvp_rule(Module& m, Id id, std::span<const Id> tangents) {
    const Inst inst = m[id];
    std::array<Id, 4> operands{}, derivatives{};
    const size_t count = tangents.size();
    for (size_t i = 0; i < count; ++i) {
        operands[i] = m.operands(id)[i];
        derivatives[i] = tangents[i];
    }
    const Operands x{&m,
                     {&m, id},
                     {&m, operands[0]},
                     {&m, operands[1]},
                     {&m, operands[2]},
                     {&m, derivatives[0]},
                     {&m, derivatives[1]},
                     {&m, derivatives[2]}};
    Value result = derive_structure(x, inst, std::span(operands.data(), count), tangents);
    if (!result) result = derive_arithmetic(x, inst.op);
    if (!result) result = derive_transcendental(x, inst.op);
    if (!result) result = derive_vector(x, inst.op);
    assert(result && "an op without a derivative rule");
    if (m.type(result.id) == inst.type || m.type(result.id) != Type::float_) return result.id;
    const std::array<Id, 4> lanes{result.id, result.id, result.id, result.id};
    return m.add(Op::construct_, std::span(lanes.data(), info(inst.type).lanes), 0, inst.type);
}

}  // namespace wrinkle
