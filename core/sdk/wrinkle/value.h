// The types of values and their operators, spelled as in GLSL: Float vec2 vec3 vec4 mat3 Int Uint
// Bool.
//
// A value is a number of the host's, nothing more: copying one copies an index. Numbers of C++
// become literals where a value is expected. Conversions are explicit, as in GLSL: Float(i),
// vec3(x). There is no default value; `if` and `while` work on C++ values only, select() and loop()
// on these.
//
//   v.x() v.xy() v.rgb() ...   swizzles; any other one is v.swizzle<"zzx">()
//   + - * /                    by components; a Float broadcasts to a vector; `/` does not guard
//                              against 0, divide() of math.h does
//   < <= > >= == !=            of scalars, giving a Bool; && || !
//   & | ^ << >>                of Int and Uint, which wrap at 32 bits
//   m * v, m * n               mat3, column-major
#pragma once

#include <concepts>
#include <cstddef>

#include "wrinkle/builder.h"

namespace wrinkle::sdk {

class Float;
class Int;
class Uint;

// A value is known when a point is computed, and the body runs before: C++ cannot branch on it.
// clang-format off
#define WRINKLE_NO_BRANCH \
    template <std::same_as<bool> B> explicit operator B() const { \
        static_assert(!std::same_as<B, bool>, \
            "write select(condition, a, b) in place of if and ?:, and loop() in place of while: " \
            "a value of a node is not known while its body runs"); \
        return false; \
    }
// clang-format on

class Bool {
public:
    static constexpr uint32_t type = WR_TYPE_bool;
    wr_value id;
    WRINKLE_NO_BRANCH
    explicit Bool(Raw raw) : id(raw.id) {}
    template <std::same_as<bool> B>
    Bool(B value) : Bool(literal(type, value)) {}
};

class Int {
public:
    static constexpr uint32_t type = WR_TYPE_int;
    wr_value id;
    WRINKLE_NO_BRANCH
    explicit Int(Raw raw) : id(raw.id) {}
    template <std::same_as<int> I>
    Int(I value) : Int(literal(type, value)) {}
    explicit Int(Float x);  // towards zero
    explicit Int(Uint x);   // the same bits
};

class Uint {
public:
    static constexpr uint32_t type = WR_TYPE_uint;
    wr_value id;
    WRINKLE_NO_BRANCH
    explicit Uint(Raw raw) : id(raw.id) {}
    template <std::same_as<unsigned> I>
    Uint(I value) : Uint(literal(type, value)) {}
    explicit Uint(Int x);  // the same bits
};

class Float {
public:
    static constexpr uint32_t type = WR_TYPE_float;
    static constexpr uint32_t lanes = 1;
    wr_value id;
    WRINKLE_NO_BRANCH
    explicit Float(Raw raw) : id(raw.id) {}
    Float(double value) : Float(literal(type, value)) {}
    explicit Float(Int x) : Float(emit(WR_OP_to_float, {x.id})) {}
    explicit Float(Uint x) : Float(emit(WR_OP_to_float, {x.id})) {}
    explicit Float(Bool x) : Float(emit(WR_OP_to_float, {x.id})) {}
};
#undef WRINKLE_NO_BRANCH

inline Int::Int(Float x) : Int(emit(WR_OP_to_int, {x.id})) {}
inline Int::Int(Uint x) : Int(emit(WR_OP_to_int, {x.id})) {}
inline Uint::Uint(Int x) : Uint(emit(WR_OP_to_uint, {x.id})) {}

class vec2;
class vec3;
class vec4;

template <uint32_t N>
struct VectorOf;
template <>
struct VectorOf<1> {
    using type = Float;
};
template <>
struct VectorOf<2> {
    using type = vec2;
};
template <>
struct VectorOf<3> {
    using type = vec3;
};
template <>
struct VectorOf<4> {
    using type = vec4;
};

// The name of a swizzle as a template argument: components of xyzw or of rgba.
template <size_t N>
struct Components {
    char text[N]{};
    consteval Components(const char (&name)[N]) {
        for (size_t i = 0; i < N; ++i)
            text[i] = name[i];
    }
    static constexpr uint32_t count = N - 1;
    static constexpr uint32_t lane(char c) {
        for (uint32_t k = 0; k < 4; ++k)
            if (c == "xyzw"[k] || c == "rgba"[k]) return k;
        return 4;
    }
    constexpr uint32_t at(size_t i) const { return i < count ? lane(text[i]) : 0; }
    constexpr uint32_t code() const { return WR_SWIZZLE(count, at(0), at(1), at(2), at(3)); }
    constexpr bool fits(uint32_t lanes) const {
        for (size_t i = 0; i < count; ++i)
            if (at(i) >= lanes) return false;
        return count >= 1 && count <= 4;
    }
};

template <Components name, class V>
auto swizzled(V v) {
    static_assert(name.fits(V::lanes), "the vector has no such components");
    return typename VectorOf<name.count>::type(emit(WR_OP_swizzle, {v.id}, name.code()));
}

// clang-format off
#define WRINKLE_SWIZZLE(name) auto name() const { return swizzled<#name>(*this); }
#define WRINKLE_SWIZZLES_2 \
    WRINKLE_SWIZZLE(x) WRINKLE_SWIZZLE(y) WRINKLE_SWIZZLE(r) WRINKLE_SWIZZLE(g) \
    WRINKLE_SWIZZLE(xy) WRINKLE_SWIZZLE(yx) WRINKLE_SWIZZLE(rg)
#define WRINKLE_SWIZZLES_3 \
    WRINKLE_SWIZZLES_2 WRINKLE_SWIZZLE(z) WRINKLE_SWIZZLE(b) WRINKLE_SWIZZLE(xz) \
    WRINKLE_SWIZZLE(zx) WRINKLE_SWIZZLE(yz) WRINKLE_SWIZZLE(zy) WRINKLE_SWIZZLE(xyz) \
    WRINKLE_SWIZZLE(yzx) WRINKLE_SWIZZLE(zxy) WRINKLE_SWIZZLE(rgb)
#define WRINKLE_SWIZZLES_4 \
    WRINKLE_SWIZZLES_3 WRINKLE_SWIZZLE(w) WRINKLE_SWIZZLE(a) WRINKLE_SWIZZLE(zw)
// clang-format on

class vec2 {
public:
    static constexpr uint32_t type = WR_TYPE_vec2;
    static constexpr uint32_t lanes = 2;
    wr_value id;
    explicit vec2(Raw raw) : id(raw.id) {}
    explicit vec2(Float all) : vec2(all, all) {}
    vec2(Float x, Float y) : vec2(emit(WR_OP_construct, {x.id, y.id}, 0, type)) {}
    template <Components name>
    auto swizzle() const {
        return swizzled<name>(*this);
    }
    WRINKLE_SWIZZLES_2
};

class vec3 {
public:
    static constexpr uint32_t type = WR_TYPE_vec3;
    static constexpr uint32_t lanes = 3;
    wr_value id;
    explicit vec3(Raw raw) : id(raw.id) {}
    explicit vec3(Float all) : vec3(all, all, all) {}
    vec3(Float x, Float y, Float z) : vec3(emit(WR_OP_construct, {x.id, y.id, z.id}, 0, type)) {}
    vec3(vec2 xy, Float z) : vec3(emit(WR_OP_construct, {xy.id, z.id}, 0, type)) {}
    vec3(Float x, vec2 yz) : vec3(emit(WR_OP_construct, {x.id, yz.id}, 0, type)) {}
    template <Components name>
    auto swizzle() const {
        return swizzled<name>(*this);
    }
    WRINKLE_SWIZZLES_3
};

class vec4 {
public:
    static constexpr uint32_t type = WR_TYPE_vec4;
    static constexpr uint32_t lanes = 4;
    wr_value id;
    explicit vec4(Raw raw) : id(raw.id) {}
    explicit vec4(Float all) : vec4(all, all, all, all) {}
    vec4(Float x, Float y, Float z, Float w)
        : vec4(emit(WR_OP_construct, {x.id, y.id, z.id, w.id}, 0, type)) {}
    vec4(vec3 xyz, Float w) : vec4(emit(WR_OP_construct, {xyz.id, w.id}, 0, type)) {}
    vec4(vec2 xy, vec2 zw) : vec4(emit(WR_OP_construct, {xy.id, zw.id}, 0, type)) {}
    template <Components name>
    auto swizzle() const {
        return swizzled<name>(*this);
    }
    WRINKLE_SWIZZLES_4
};

#undef WRINKLE_SWIZZLES_4
#undef WRINKLE_SWIZZLES_3
#undef WRINKLE_SWIZZLES_2
#undef WRINKLE_SWIZZLE

class mat3 {
public:
    static constexpr uint32_t type = WR_TYPE_mat3;
    wr_value id;
    explicit mat3(Raw raw) : id(raw.id) {}
    mat3(vec3 column0, vec3 column1, vec3 column2)
        : mat3(emit(WR_OP_construct, {column0.id, column1.id, column2.id}, 0, type)) {}
    vec3 column(uint32_t which) const { return vec3(emit(WR_OP_column, {id}, which)); }
};

inline vec3 operator*(mat3 m, vec3 v) {
    return vec3(emit(WR_OP_transform, {m.id, v.id}));
}
inline mat3 operator*(mat3 a, mat3 b) {
    return mat3(emit(WR_OP_matrix_product, {a.id, b.id}));
}

// clang-format off
#define WRINKLE_BINARY(R, A, symbol, B, op) \
    inline R operator symbol(A a, B b) { return R(emit(WR_OP_##op, {a.id, b.id})); }
#define WRINKLE_ASSIGN(T, symbol, B) \
    inline T& operator symbol##=(T& a, B b) { return a = a symbol b; }
#define WRINKLE_ARITHMETIC(R, A, B) \
    WRINKLE_BINARY(R, A, +, B, add) WRINKLE_BINARY(R, A, -, B, sub) WRINKLE_BINARY(R, A, *, B, mul)
#define WRINKLE_ASSIGNMENTS(T, B) \
    WRINKLE_ASSIGN(T, +, B) WRINKLE_ASSIGN(T, -, B) WRINKLE_ASSIGN(T, *, B)
#define WRINKLE_NUMBER(T) \
    WRINKLE_ARITHMETIC(T, T, T) WRINKLE_ASSIGNMENTS(T, T) \
    inline T operator-(T a) { return T(emit(WR_OP_neg, {a.id})); }
#define WRINKLE_FLOATS(T) \
    WRINKLE_NUMBER(T) WRINKLE_BINARY(T, T, /, T, div) WRINKLE_ASSIGN(T, /, T)
#define WRINKLE_VECTOR(V) \
    WRINKLE_FLOATS(V) \
    WRINKLE_ARITHMETIC(V, V, Float) WRINKLE_ARITHMETIC(V, Float, V) WRINKLE_ASSIGNMENTS(V, Float) \
    WRINKLE_BINARY(V, V, /, Float, div) WRINKLE_BINARY(V, Float, /, V, div) \
    WRINKLE_ASSIGN(V, /, Float)
#define WRINKLE_COMPARE(T) \
    WRINKLE_BINARY(Bool, T, <, T, lt) WRINKLE_BINARY(Bool, T, <=, T, le) \
    WRINKLE_BINARY(Bool, T, >, T, gt) WRINKLE_BINARY(Bool, T, >=, T, ge) \
    WRINKLE_BINARY(Bool, T, ==, T, eq) WRINKLE_BINARY(Bool, T, !=, T, ne)
#define WRINKLE_BITS(T) \
    WRINKLE_BINARY(T, T, &, T, bit_and) WRINKLE_BINARY(T, T, |, T, bit_or) \
    WRINKLE_BINARY(T, T, ^, T, bit_xor) \
    WRINKLE_BINARY(T, T, <<, T, shift_left) WRINKLE_BINARY(T, T, >>, T, shift_right) \
    WRINKLE_ASSIGN(T, &, T) WRINKLE_ASSIGN(T, |, T) WRINKLE_ASSIGN(T, ^, T) \
    WRINKLE_ASSIGN(T, <<, T) WRINKLE_ASSIGN(T, >>, T)

WRINKLE_FLOATS(Float)
WRINKLE_VECTOR(vec2)
WRINKLE_VECTOR(vec3)
WRINKLE_VECTOR(vec4)
WRINKLE_NUMBER(Int)
WRINKLE_NUMBER(Uint)
WRINKLE_COMPARE(Float)
WRINKLE_COMPARE(Int)
WRINKLE_COMPARE(Uint)
WRINKLE_BITS(Int)
WRINKLE_BITS(Uint)
WRINKLE_BINARY(Bool, Bool, &&, Bool, and)
WRINKLE_BINARY(Bool, Bool, ||, Bool, or)
// clang-format on
// With a bool of C++: its own && would ask the value for one.
template <std::same_as<bool> B>
Bool operator&&(Bool a, B b) {
    return a && Bool(b);
}
template <std::same_as<bool> B>
Bool operator&&(B a, Bool b) {
    return Bool(a) && b;
}
template <std::same_as<bool> B>
Bool operator||(Bool a, B b) {
    return a || Bool(b);
}
template <std::same_as<bool> B>
Bool operator||(B a, Bool b) {
    return Bool(a) || b;
}
inline Bool operator!(Bool a) {
    return Bool(emit(WR_OP_not, {a.id}));
}

#undef WRINKLE_BITS
#undef WRINKLE_COMPARE
#undef WRINKLE_VECTOR
#undef WRINKLE_FLOATS
#undef WRINKLE_NUMBER
#undef WRINKLE_ASSIGNMENTS
#undef WRINKLE_ARITHMETIC
#undef WRINKLE_ASSIGN
#undef WRINKLE_BINARY

// clang-format off
template <class T>
concept FloatType = requires { T::lanes; };
template <class T>
concept VectorType = FloatType<T> && (T::lanes > 1);
template <class T>
concept ValueType = requires { T::type; };
// clang-format on

// One of two values; both are computed.
template <ValueType T>
T select(Bool condition, T yes, std::type_identity_t<T> no) {
    return T(emit(WR_OP_select, {condition.id, yes.id, no.id}));
}
inline Float select(Bool condition, double yes, double no) {
    return select(condition, Float(yes), Float(no));
}
inline Float select(Bool condition, double yes, Float no) {
    return select(condition, Float(yes), no);
}

// The same value, but constant under every derivative.
template <FloatType T>
T detach(T x) {
    return T(emit(WR_OP_detach, {x.id}));
}

}  // namespace wrinkle::sdk
