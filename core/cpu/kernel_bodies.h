// The code of kernels.h, included once for each instruction set. A step's output is never one of
// its operands (registers.cpp), so the loops vectorise.
#ifndef WRINKLE_ISA
#error "say for which instruction set: define WRINKLE_ISA"
#endif

#include <cmath>
#include <type_traits>

#include "base/transcendental.h"
#include "cpu/kernels.h"

namespace wrinkle::WRINKLE_ISA {
namespace {

template <class Lane>
Lane* lanes_of(Lane* registers, uint32_t reg) {
    return registers + reg * tile_lanes;
}

// out = f(a), f(a, b) or f(a, b, c) on every lane, all of them in one file of registers.
template <class A, class Out, class F>
bool each(const Step& step, const A* from, Out* to, size_t n, F f) {
    const A *a = lanes_of(from, step.in[0]), *b = lanes_of(from, step.in[1]),
            *c = lanes_of(from, step.in[2]);
    Out* __restrict out = lanes_of(to, step.out[0]);
    for (size_t k = 0; k < n; ++k) {
        if constexpr (std::is_invocable_v<F, A>)
            out[k] = f(a[k]);
        else if constexpr (std::is_invocable_v<F, A, A>)
            out[k] = f(a[k], b[k]);
        else
            out[k] = f(a[k], b[k], c[k]);
    }
    return true;
}

template <class Lane>
bool select(const Step& step, const uint32_t* integers, Lane* registers, size_t n) {
    const uint32_t* condition = lanes_of(integers, step.in[0]);
    const Lane *a = lanes_of(registers, step.in[1]), *b = lanes_of(registers, step.in[2]);
    Lane* __restrict out = lanes_of(registers, step.out[0]);
    for (size_t k = 0; k < n; ++k)
        out[k] = condition[k] ? a[k] : b[k];
    return true;
}

template <class T>
bool arithmetic(const Step& step, T* r, size_t n) {
    switch (step.op) {
        case Op::neg_:
            return each(step, r, r, n, [](T x) { return -x; });
        case Op::add_:
            return each(step, r, r, n, [](T x, T y) { return x + y; });
        case Op::sub_:
            return each(step, r, r, n, [](T x, T y) { return x - y; });
        case Op::mul_:
            return each(step, r, r, n, [](T x, T y) { return x * y; });
        case Op::div_:
            return each(step, r, r, n, [](T x, T y) { return x / y; });
        case Op::mod_:
            return each(step, r, r, n, [](T x, T y) { return x - y * math::floor(x / y); });
        case Op::mix_:
            return each(step, r, r, n, [](T x, T y, T t) { return x * (1 - t) + y * t; });
        case Op::min_:
            return each(step, r, r, n, [](T x, T y) { return y < x ? y : x; });
        case Op::max_:
            return each(step, r, r, n, [](T x, T y) { return x < y ? y : x; });
        case Op::sqrt_:
            return each(step, r, r, n, [](T x) { return std::sqrt(x); });
        case Op::inversesqrt_:
            return each(step, r, r, n, [](T x) { return 1 / std::sqrt(x); });
        default:
            return false;
    }
}

template <class T>
T clamped(T x, T low, T high) {
    const T above = x < low ? low : x;
    return high < above ? high : above;
}

template <class T>
T smoothstep(T low, T high, T x) {
    const T t = clamped((x - low) / (high - low), T(0), T(1));
    return t * t * (3 - 2 * t);
}

template <class T>
bool shaping(const Step& step, T* r, size_t n) {
    switch (step.op) {
        case Op::abs_:
            return each(step, r, r, n, [](T x) { return std::fabs(x); });
        case Op::sign_:
            return each(step, r, r, n, [](T x) { return T(x > 0) - T(x < 0); });
        case Op::sign_nonzero_:
            return each(step, r, r, n, [](T x) { return x < 0 ? T(-1) : T(1); });
        case Op::floor_:
            return each(step, r, r, n, [](T x) { return math::floor(x); });
        case Op::ceil_:
            return each(step, r, r, n, [](T x) { return -math::floor(-x); });
        case Op::fract_:
            return each(step, r, r, n, [](T x) { return x - math::floor(x); });
        case Op::clamp_:
            return each(step, r, r, n, [](T x, T a, T b) { return clamped(x, a, b); });
        case Op::step_:
            return each(step, r, r, n, [](T e, T x) { return x < e ? T(0) : T(1); });
        case Op::smoothstep_:
            return each(step, r, r, n, [](T a, T b, T x) { return smoothstep(a, b, x); });
        default:
            return false;
    }
}

template <class T>
bool transcendental(const Step& step, T* r, size_t n) {
    switch (step.op) {
        case Op::pow_:
            return each(step, r, r, n, [](T x, T y) { return math::pow(x, y); });
        case Op::exp_:
            return each(step, r, r, n, [](T x) { return math::exp(x); });
        case Op::log_:
            return each(step, r, r, n, [](T x) { return math::log(x); });
        case Op::exp2_:
            return each(step, r, r, n, [](T x) { return math::exp2(x); });
        case Op::log2_:
            return each(step, r, r, n, [](T x) { return math::log2(x); });
        case Op::sin_:
            return each(step, r, r, n, [](T x) { return math::sin(x); });
        case Op::cos_:
            return each(step, r, r, n, [](T x) { return math::cos(x); });
        case Op::tan_:
            return each(step, r, r, n, [](T x) { return math::tan(x); });
        case Op::asin_:
            return each(step, r, r, n, [](T x) { return math::asin(x); });
        case Op::acos_:
            return each(step, r, r, n, [](T x) { return math::acos(x); });
        case Op::atan_:
            return each(step, r, r, n, [](T x) { return math::atan(x); });
        case Op::atan2_:
            return each(step, r, r, n, [](T y, T x) { return math::atan2(y, x); });
        default:
            return false;
    }
}

// A is the type of the operands, whose registers are `from`.
template <class A>
bool comparison(const Step& step, const A* from, uint32_t* to, size_t n) {
    switch (step.op) {
        case Op::lt_:
            return each(step, from, to, n, [](A x, A y) { return uint32_t(x < y); });
        case Op::le_:
            return each(step, from, to, n, [](A x, A y) { return uint32_t(x <= y); });
        case Op::gt_:
            return each(step, from, to, n, [](A x, A y) { return uint32_t(x > y); });
        case Op::ge_:
            return each(step, from, to, n, [](A x, A y) { return uint32_t(x >= y); });
        case Op::eq_:
            return each(step, from, to, n, [](A x, A y) { return uint32_t(x == y); });
        case Op::ne_:
            return each(step, from, to, n, [](A x, A y) { return uint32_t(x != y); });
        default:
            return false;
    }
}

// What int and uint have in common: two's complement makes these the same.
bool words(const Step& step, uint32_t* r, size_t n) {
    using W = uint32_t;
    switch (step.op) {
        case Op::neg_:
            return each(step, r, r, n, [](W x) { return 0u - x; });
        case Op::add_:
            return each(step, r, r, n, [](W x, W y) { return x + y; });
        case Op::sub_:
            return each(step, r, r, n, [](W x, W y) { return x - y; });
        case Op::mul_:
            return each(step, r, r, n, [](W x, W y) { return x * y; });
        case Op::and_:
        case Op::bit_and_:
            return each(step, r, r, n, [](W x, W y) { return x & y; });
        case Op::or_:
        case Op::bit_or_:
            return each(step, r, r, n, [](W x, W y) { return x | y; });
        case Op::bit_xor_:
            return each(step, r, r, n, [](W x, W y) { return x ^ y; });
        case Op::not_:
            return each(step, r, r, n, [](W x) { return x ^ 1u; });
        case Op::shift_left_:
            return each(step, r, r, n, [](W x, W y) { return x << (y & 31); });
        case Op::to_int_:
        case Op::to_uint_:
            return each(step, r, r, n, [](W x) { return x; });
        default:
            return false;
    }
}

// S is int32_t or uint32_t: what depends on the sign.
template <class S>
bool ordered(const Step& step, S* r, size_t n) {
    switch (step.op) {
        case Op::min_:
            return each(step, r, r, n, [](S x, S y) { return y < x ? y : x; });
        case Op::max_:
            return each(step, r, r, n, [](S x, S y) { return x < y ? y : x; });
        case Op::shift_right_:
            return each(step, r, r, n, [](S x, S y) { return x >> (y & 31); });
        default:
            return false;
    }
}

// Towards zero; what does not fit becomes the nearest int, NaN 0.
template <class T>
uint32_t truncated(T x) {
    constexpr T low = T(-2147483648.0), high = sizeof(T) == 4 ? T(2147483520.0) : T(2147483647.0);
    return static_cast<uint32_t>(static_cast<int32_t>(clamped(x == x ? x : T(0), low, high)));
}

template <class T>
bool on_floats(const Step& step, const Registers<T>& r, size_t n) {
    if (step.op == Op::select_) return select(step, r.integers, r.floats, n);
    if (step.op == Op::to_int_) return each(step, r.floats, r.integers, n, truncated<T>);
    return arithmetic(step, r.floats, n) || shaping(step, r.floats, n) ||
           transcendental(step, r.floats, n) || comparison(step, r.floats, r.integers, n);
}

template <class T, class S>
bool on_integers(const Step& step, const Registers<T>& r, S* integers, size_t n) {
    if (step.op == Op::select_) return select(step, r.integers, r.integers, n);
    if (step.op == Op::to_float_)
        return each(step, static_cast<const S*>(integers), r.floats, n,
                    [](S x) { return static_cast<T>(x); });
    return words(step, r.integers, n) || ordered(step, integers, n) ||
           comparison(step, static_cast<const S*>(integers), r.integers, n);
}

template <class T>
bool run(const Step& step, const Registers<T>& r, size_t n) {
    if (step.type == Type::float_) return on_floats(step, r, n);
    if (step.type == Type::int_)
        return on_integers(step, r, reinterpret_cast<int32_t*>(r.integers), n);
    return on_integers(step, r, r.integers, n);
}

}  // namespace

bool run_op(const Step& step, const Registers<float>& registers, size_t n) {
    return run(step, registers, n);
}
bool run_op(const Step& step, const Registers<double>& registers, size_t n) {
    return run(step, registers, n);
}

}  // namespace wrinkle::WRINKLE_ISA
