// Functions of values, named as in GLSL and guarded at the corners: but for overflow (exp, pow,
// tan, a quotient by next to nothing) finite for every finite input. sin, cos and tan are for
// angles up to 1e6 or so; far beyond, targets differ.
//
//   sqrt of a negative is 0; inversesqrt, log, log2 of x <= 0 are 0, log and log2 of the least
//   normal float; pow(x, y) of x < 0 is that of 0, pow(0, y) of y < 0 is 0, of 0 it is 1; asin and
//   acos clamp; normalize of a zero vector is zero; atan(0, 0) is 0; divide(a, b) and mod(a, b) are
//   0 where b is 0; smoothstep between equal edges is a step.
// A second argument that is a number of C++ costs no guard where it needs none.
#pragma once

#include "wrinkle/value.h"

namespace wrinkle::sdk {

// Names a value in the generated source: "slope". In a function() it is then a separate statement.
// "pi // half a turn": a constant with a comment, the same for all nodes.
template <class T>
T named(const char* name, T value) {
    if (builder) builder->name(builder, value.id, name);
    return value;
}
inline Float pi() {
    return named("pi // half a turn, in radians", Float(3.141592653589793));
}
inline Float two_pi() {
    return named("two_pi // a turn, in radians", Float(6.283185307179586));
}
namespace detail {
inline Float least_float() {
    return named("min_float // the least normal float", Float(1.17549435e-38));
}
}  // namespace detail

// clang-format off
#define WRINKLE_UNARY(name) \
    template <FloatType T> T name(T x) { return T(emit(WR_OP_##name, {x.id})); }
WRINKLE_UNARY(abs)
WRINKLE_UNARY(sign)
WRINKLE_UNARY(floor)
WRINKLE_UNARY(ceil)
WRINKLE_UNARY(fract)
WRINKLE_UNARY(exp)
WRINKLE_UNARY(exp2)
WRINKLE_UNARY(sin)
WRINKLE_UNARY(cos)
WRINKLE_UNARY(tan)
WRINKLE_UNARY(atan)
WRINKLE_UNARY(ddx) /* the change to the next pixel in x */
WRINKLE_UNARY(ddy)
#undef WRINKLE_UNARY

#define WRINKLE_BINARY(name) \
    inline Float name(Float a, Float b) { return Float(emit(WR_OP_##name, {a.id, b.id})); } \
    inline Int name(Int a, Int b) { return Int(emit(WR_OP_##name, {a.id, b.id})); } \
    inline Uint name(Uint a, Uint b) { return Uint(emit(WR_OP_##name, {a.id, b.id})); } \
    template <VectorType V> V name(V a, std::type_identity_t<V> b) { \
        return V(emit(WR_OP_##name, {a.id, b.id})); \
    } \
    template <VectorType V> V name(V a, Float b) { return V(emit(WR_OP_##name, {a.id, b.id})); }
WRINKLE_BINARY(min)
WRINKLE_BINARY(max)
#undef WRINKLE_BINARY
// clang-format on

inline Float sign_nonzero(Float x) {
    return Float(emit(WR_OP_sign_nonzero, {x.id}));
}

template <FloatType T>
T fwidth(T x) {
    return abs(ddx(x)) + abs(ddy(x));
}

inline Float clamp(Float x, Float low, Float high) {
    return Float(emit(WR_OP_clamp, {x.id, low.id, high.id}));
}
template <VectorType V>
V clamp(V x, Float low, Float high) {
    return V(emit(WR_OP_clamp, {x.id, low.id, high.id}));
}
template <VectorType V>
V clamp(V x, std::type_identity_t<V> low, std::type_identity_t<V> high) {
    return V(emit(WR_OP_clamp, {x.id, low.id, high.id}));
}
template <FloatType T>
T saturate(T x) {
    return clamp(x, 0, 1);
}

inline Float mix(Float a, Float b, Float t) {
    return Float(emit(WR_OP_mix, {a.id, b.id, t.id}));
}
template <VectorType V>
V mix(V a, V b, Float t) {
    return V(emit(WR_OP_mix, {a.id, b.id, t.id}));
}
template <VectorType V>
V mix(V a, V b, std::type_identity_t<V> t) {
    return V(emit(WR_OP_mix, {a.id, b.id, t.id}));
}

inline Float step(Float edge, Float x) {
    return Float(emit(WR_OP_step, {edge.id, x.id}));
}

// A function of Floats by components.
template <class F>
Float by_components(Float x, F f) {
    return f(x);
}
template <class F>
vec2 by_components(vec2 v, F f) {
    return {f(v.x()), f(v.y())};
}
template <class F>
vec3 by_components(vec3 v, F f) {
    return {f(v.x()), f(v.y()), f(v.z())};
}
template <class F>
vec4 by_components(vec4 v, F f) {
    return {f(v.x()), f(v.y()), f(v.z()), f(v.w())};
}

template <FloatType T>
T divide(T a, Float b) {
    return select(b != 0, a / b, T(Float(0)));
}
inline Float divide(Float a, Float b) {
    return select(b != 0, a / b, Float(0));
}
inline vec2 divide(vec2 a, vec2 b) {
    return {divide(a.x(), b.x()), divide(a.y(), b.y())};
}
inline vec3 divide(vec3 a, vec3 b) {
    return {divide(a.x(), b.x()), divide(a.y(), b.y()), divide(a.z(), b.z())};
}
inline vec4 divide(vec4 a, vec4 b) {
    return {divide(a.xy(), b.xy()), divide(a.zw(), b.zw())};
}

// x - y floor(x / y): the result has the sign of y.
template <FloatType T>
T mod(T x, double y) {
    if (y == 0) return T(Float(0));
    return T(emit(WR_OP_mod, {x.id, Float(y).id}));
}
template <FloatType T>
T mod(T x, Float y) {
    return select(y != 0, T(emit(WR_OP_mod, {x.id, y.id})), T(Float(0)));
}

// Between equal edges a step, and between edges in falling order the mirrored curve.
inline Float smoothstep(Float low, Float high, Float x) {
    const auto rise = [&](Float from, Float to) {
        return Float(emit(WR_OP_smoothstep, {from.id, to.id, x.id}));
    };
    return select(low < high, rise(low, high),
                  select(high < low, 1 - rise(high, low), step(low, x)));
}

template <FloatType T>
T sqrt(T x) {
    return T(emit(WR_OP_sqrt, {max(x, 0).id}));
}
template <FloatType T>
T inversesqrt(T x) {
    return by_components(
        x, [](Float c) { return select(c > 0, Float(emit(WR_OP_inversesqrt, {c.id})), 0); });
}
template <FloatType T>
T log(T x) {
    return T(emit(WR_OP_log, {max(x, detail::least_float()).id}));
}
template <FloatType T>
T log2(T x) {
    return T(emit(WR_OP_log2, {max(x, detail::least_float()).id}));
}
template <FloatType T>
T asin(T x) {
    return T(emit(WR_OP_asin, {clamp(x, -1, 1).id}));
}
template <FloatType T>
T acos(T x) {
    return T(emit(WR_OP_acos, {clamp(x, -1, 1).id}));
}

inline Float pow(Float x, double y) {
    if (y == 0) return 1;
    if (y == 1) return max(x, 0);
    if (y > 0) return Float(emit(WR_OP_pow, {max(x, 0).id, Float(y).id}));
    return select(x > 0, Float(emit(WR_OP_pow, {x.id, Float(y).id})), 0);
}
inline Float pow(Float x, Float y) {
    return select(x > 0, Float(emit(WR_OP_pow, {x.id, y.id})), select(y == 0, 1.0, 0.0));
}
template <VectorType V>
V pow(V x, Float y) {
    return by_components(x, [y](Float c) { return pow(c, y); });
}
inline Float atan(Float y, Float x) {
    return select(abs(x) + abs(y) > 0, Float(emit(WR_OP_atan2, {y.id, x.id})), 0);
}

template <VectorType V>
Float dot(V a, std::type_identity_t<V> b) {
    return Float(emit(WR_OP_dot, {a.id, b.id}));
}
template <VectorType V>
Float length(V v) {
    return Float(emit(WR_OP_length, {v.id}));
}
template <VectorType V>
Float distance(V a, std::type_identity_t<V> b) {
    return length(a - b);
}
template <VectorType V>
V normalize(V v) {
    return select(dot(v, v) > 0, V(emit(WR_OP_normalize, {v.id})), V(Float(0)));
}
// `value` with a derivative of the author's own: d(value)/d(at) = slope, whatever value is made of.
template <VectorType V>
Float with_slope(Float value, V at, std::type_identity_t<V> slope) {
    return detach(value) + dot(detach(slope), at - detach(at));
}
inline vec3 cross(vec3 a, vec3 b) {
    return vec3(emit(WR_OP_cross, {a.id, b.id}));
}
// About a unit normal.
template <VectorType V>
V reflect(V v, std::type_identity_t<V> normal) {
    return V(emit(WR_OP_reflect, {v.id, normal.id}));
}
inline mat3 transpose(mat3 m) {
    return mat3(emit(WR_OP_transpose, {m.id}));
}
inline Float radians(Float degrees) {
    return degrees * named("degree // in radians", Float(0.017453292519943295));
}
inline Float degrees(Float radians) {
    return radians * named("radian // in degrees", Float(57.29577951308232));
}

}  // namespace wrinkle::sdk
