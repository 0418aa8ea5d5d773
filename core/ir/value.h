// A value of a module with operators, so that passes read like the formulas they implement.
//   Value gamma = t * slope.x() + b * slope.y();
// A Value is an Id and its module; every operator is one Module::add(). With the Id no_id it is
// empty.
#pragma once

#include "ir/module.h"

namespace wrinkle {

struct Value {
    Module* module = nullptr;
    Id id = no_id;

    Value x() const { return {module, module->component(id, 0)}; }
    Value y() const { return {module, module->component(id, 1)}; }
    Value z() const { return {module, module->component(id, 2)}; }
    Value w() const { return {module, module->component(id, 3)}; }
    Value xy() const { return {module, module->swizzle(id, "xy")}; }
    Value xyz() const { return {module, module->swizzle(id, "xyz")}; }
    explicit operator bool() const { return id != no_id; }
};

// Name the value in generated source: surface_named() for values of the surface point, shared by
// all nodes; named() for values of the current node.
inline Value surface_named(std::string_view name, Value a) {
    a.module->name(a.id, 0, name);
    return a;
}
inline Value named(std::string_view name, Value a) {
    a.module->name(a.id, a.module->current_node, name);
    return a;
}

inline Value op(Op o, Value a) {
    return {a.module, a.module->add(o, {a.id})};
}
inline Value op(Op o, Value a, Value b) {
    return {a.module, a.module->add(o, {a.id, b.id})};
}
inline Value op(Op o, Value a, Value b, Value c) {
    return {a.module, a.module->add(o, {a.id, b.id, c.id})};
}
inline Value number(Value like, double value) {
    return {like.module, like.module->number(value)};
}
// A constant with a name and a comment in generated source: "min_area // why".
inline Value constant(std::string_view name, Value like, double value) {
    return surface_named(name, number(like, value));
}
// Areas and squared lengths below it count as zero. It is well under (pixel size)^4 of any sensible
// scene: a higher floor would flatten bumps seen from a short distance.
inline Value min_area(Value like) {
    return constant("min_area // smaller areas and squared lengths are zero", like, 1e-36);
}
inline Value vec3(Value xy, Value z) {
    return {xy.module, xy.module->construct(Type::vec3_, {xy.id, z.id})};
}
inline Value vec2(Value a, Value b) {
    return {a.module, a.module->construct(Type::vec2_, {a.id, b.id})};
}
inline Value vec3(Value a, Value b, Value c) {
    return {a.module, a.module->construct(Type::vec3_, {a.id, b.id, c.id})};
}

inline Value operator-(Value a) {
    return op(Op::neg_, a);
}
inline Value operator+(Value a, Value b) {
    return op(Op::add_, a, b);
}
inline Value operator-(Value a, Value b) {
    return op(Op::sub_, a, b);
}
inline Value operator*(Value a, Value b) {
    return op(Op::mul_, a, b);
}
inline Value operator*(Value a, double b) {
    return op(Op::mul_, a, number(a, b));
}
inline Value operator/(Value a, Value b) {
    return op(Op::div_, a, b);
}
// An empty Value is zero.
inline Value sum_of(Value a, Value b) {
    return !a ? b : !b ? a : a + b;
}
inline Value product_of(Value a, Value factor) {
    return a && factor ? a * factor : a;
}
// A vector times a factor. An empty factor is 1, an empty vector zero.
struct Scaled {
    Value vector, factor;
};
// Moves scalar factors of a product to the factor.
inline Scaled without_factors(Value vector, Value factor) {
    Module& m = *vector.module;
    while (m[vector.id].op == Op::mul_) {
        const Inst inst = m[vector.id];
        const size_t scalar = m.type(inst.arg[0]) == Type::float_ ? 0 : 1;
        if (m.type(inst.arg[scalar]) != Type::float_) break;
        const Value moved{&m, inst.arg[scalar]};
        factor = factor ? moved * factor : moved;
        vector.id = inst.arg[1 - scalar];
    }
    return {vector, factor};
}
inline Value abs(Value a) {
    return op(Op::abs_, a);
}
inline Value max(Value a, Value b) {
    return op(Op::max_, a, b);
}
inline Value max(Value a, double b) {
    return op(Op::max_, a, number(a, b));
}
inline Value dot(Value a, Value b) {
    return op(Op::dot_, a, b);
}
inline Value cross(Value a, Value b) {
    return op(Op::cross_, a, b);
}
inline Value normalize(Value a) {
    return op(Op::normalize_, a);
}
inline Value inversesqrt(Value a) {
    return op(Op::inversesqrt_, a);
}
inline Value sign_nonzero(Value a) {
    return op(Op::sign_nonzero_, a);
}
inline Value detach(Value a) {
    return op(Op::detach_, a);
}
inline Value greater(Value a, Value b) {
    return op(Op::gt_, a, b);
}
inline Value greater(Value a, double b) {
    return greater(a, number(a, b));
}
inline Value select(Value condition, Value a, Value b) {
    return op(Op::select_, condition, a, b);
}

}  // namespace wrinkle
