// The meaning of every op that works lane by lane: one function per op, for folding (double) and
// for the kernels of every instruction set (float and double).
//
// The corners are those documented above the op table (wrinkle/plugin.h). Functions are always
// inlined, so a file compiled for another instruction set shares none of their code with the rest
// of the program.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/transcendental.h"
#include "ir/op.h"

// X(op, parameters, result). T is float or double.
#define WRINKLE_FLOAT_OPS(X)                                                        \
    X(neg, (T x), -x)                                                               \
    X(add, (T x, T y), x + y)                                                       \
    X(sub, (T x, T y), x - y)                                                       \
    X(mul, (T x, T y), x* y)                                                        \
    X(div, (T x, T y), x / y)                                                       \
    X(mod, (T x, T y), x - y * math::floor(x / y))                                  \
    X(abs, (T x), std::fabs(x))                                                     \
    X(sign, (T x), T(x > 0) - T(x < 0))                                             \
    X(sign_nonzero, (T x), x < 0 ? T(-1) : T(1))                                    \
    X(floor, (T x), math::floor(x))                                                 \
    X(ceil, (T x), -math::floor(-x))                                                \
    X(fract, (T x), x - math::floor(x))                                             \
    X(min, (T x, T y), y < x ? y : x)                                               \
    X(max, (T x, T y), x < y ? y : x)                                               \
    X(clamp, (T x, T low, T high), clamped(x, low, high))                           \
    X(mix, (T x, T y, T t), x*(1 - t) + y * t)                                      \
    X(step, (T edge, T x), x < edge ? T(0) : T(1))                                  \
    X(smoothstep, (T a, T b, T x), hermite(clamped((x - a) / (b - a), T(0), T(1)))) \
    X(sqrt, (T x), std::sqrt(x))                                                    \
    X(inversesqrt, (T x), 1 / std::sqrt(x))                                         \
    X(pow, (T x, T y), math::pow(x, y))                                             \
    X(exp, (T x), math::exp(x))                                                     \
    X(log, (T x), math::log(x))                                                     \
    X(exp2, (T x), math::exp2(x))                                                   \
    X(log2, (T x), math::log2(x))                                                   \
    X(sin, (T x), math::sin(x))                                                     \
    X(cos, (T x), math::cos(x))                                                     \
    X(tan, (T x), math::tan(x))                                                     \
    X(asin, (T x), math::asin(x))                                                   \
    X(acos, (T x), math::acos(x))                                                   \
    X(atan, (T x), math::atan(x))                                                   \
    X(atan2, (T y, T x), math::atan2(y, x))

// To bool; T is any number.
#define WRINKLE_COMPARISONS(X) \
    X(lt, (T x, T y), x < y)   \
    X(le, (T x, T y), x <= y)  \
    X(gt, (T x, T y), x > y)   \
    X(ge, (T x, T y), x >= y)  \
    X(eq, (T x, T y), x == y)  \
    X(ne, (T x, T y), x != y)

// T is uint32_t: ops that are the same for int and uint in two's complement, and those of bool.
#define WRINKLE_WORD_OPS(X)                  \
    X(neg, (T x), 0U - x)                    \
    X(add, (T x, T y), x + y)                \
    X(sub, (T x, T y), x - y)                \
    X(mul, (T x, T y), x* y)                 \
    X(bit_and, (T x, T y), x& y)             \
    X(bit_or, (T x, T y), x | y)             \
    X(bit_xor, (T x, T y), x ^ y)            \
    X(shift_left, (T x, T y), x << (y & 31)) \
    X(and, (T x, T y), x& y)                 \
    X(or, (T x, T y), x | y)                 \
    X(not, (T x), x ^ 1U)

// T is int32_t or uint32_t: ops that depend on the sign.
#define WRINKLE_ORDERED_OPS(X)        \
    X(min, (T x, T y), y < x ? y : x) \
    X(max, (T x, T y), x < y ? y : x) \
    X(shift_right, (T x, T y), x >> (y & 31))

// Per family: a function object per op, and find(op, use), which returns use(function object), or
// Result{} for an op of another family.
namespace wrinkle::meaning {

template <class T>
[[gnu::always_inline]] inline T clamped(T x, T low, T high) {
    const T above = x < low ? low : x;
    return high < above ? high : above;
}
template <class T>
[[gnu::always_inline]] inline T hermite(T t) {
    return t * t * (3 - 2 * t);
}

#define WRINKLE_FUNCTION(name, parameters, result)                \
    struct name##_ {                                              \
        template <class T>                                        \
        [[gnu::always_inline]] auto operator() parameters const { \
            return result;                                        \
        }                                                         \
    };
#define WRINKLE_CASE(name, parameters, result) \
    case Op::name##_:                          \
        return use(name##_{});
#define WRINKLE_FAMILY(OPS)            \
    OPS(WRINKLE_FUNCTION)              \
    template <class Result, class Use> \
    Result find(Op op, Use use) {      \
        switch (op) {                  \
            OPS(WRINKLE_CASE)          \
            default:                   \
                return {};             \
        }                              \
    }

namespace floats {
WRINKLE_FAMILY(WRINKLE_FLOAT_OPS)
}
namespace comparisons {
WRINKLE_FAMILY(WRINKLE_COMPARISONS)
}
namespace words {
WRINKLE_FAMILY(WRINKLE_WORD_OPS)
}
namespace ordered {
WRINKLE_FAMILY(WRINKLE_ORDERED_OPS)
}

#undef WRINKLE_FAMILY
#undef WRINKLE_CASE
#undef WRINKLE_FUNCTION

}  // namespace wrinkle::meaning
