// Kernels of kernels.h, included once per instruction set. A step's output register is never one of
// its operands (registers.cpp), so the loops vectorise.
#ifndef WRINKLE_ISA
#error "say for which instruction set: define WRINKLE_ISA"
#endif

#include <cmath>
#include <type_traits>

#include "base/transcendental.h"
#include "cpu/fused_bodies.h"
#include "cpu/kernels.h"
#include "cpu/sample_bodies.h"
// Included after sample_bodies.h, which includes vectors.h.
#include "cpu/interpolate_bodies.h"

namespace wrinkle::WRINKLE_ISA {
namespace {

// Computes out = f(a), f(a, b) or f(a, b, c) on every lane.
template <class T, class A, class Out, class F>
void each(const Step& step, const Registers<T>& registers, size_t n) {
    const A *a = lanes_of<A>(registers, step.in[0]), *b = lanes_of<A>(registers, step.in[1]),
            *c = lanes_of<A>(registers, step.in[2]);
    Out* __restrict out = lanes_of<Out>(registers, step.out[0]);
    WRINKLE_LANES
    for (size_t k = 0; k < n; ++k) {
        if constexpr (std::is_invocable_v<F, A>)
            out[k] = F{}(a[k]);
        else if constexpr (std::is_invocable_v<F, A, A>)
            out[k] = F{}(a[k], b[k]);
        else
            out[k] = F{}(a[k], b[k], c[k]);
    }
}

template <class T, class A, class Out, class F>
StepKernel<T> on(F) {
    return each<T, A, Out, F>;
}
template <class T, class F>
StepKernel<T> floats(F) {
    return each<T, T, T, F>;
}
template <class T, class F>
StepKernel<T> integers(F) {
    return each<T, uint32_t, uint32_t, F>;
}

template <class T, class Lane>
void select(const Step& step, const Registers<T>& registers, size_t n) {
    const uint32_t* condition = lanes_of<uint32_t>(registers, step.in[0]);
    const Lane *a = lanes_of<Lane>(registers, step.in[1]),
               *b = lanes_of<Lane>(registers, step.in[2]);
    Lane* __restrict out = lanes_of<Lane>(registers, step.out[0]);
    WRINKLE_LANES
    for (size_t k = 0; k < n; ++k)
        out[k] = condition[k] ? a[k] : b[k];
}

template <class T>
StepKernel<T> arithmetic(Op op) {
    switch (op) {
        case Op::neg_:
            return floats<T>([](T x) { return -x; });
        case Op::add_:
            return floats<T>(Add{});
        case Op::sub_:
            return floats<T>(Sub{});
        case Op::mul_:
            return floats<T>(Mul{});
        case Op::div_:
            return floats<T>([](T x, T y) { return x / y; });
        case Op::mod_:
            return floats<T>([](T x, T y) { return x - y * math::floor(x / y); });
        case Op::mix_:
            return floats<T>([](T x, T y, T t) { return x * (1 - t) + y * t; });
        case Op::min_:
            return floats<T>(Min{});
        case Op::max_:
            return floats<T>(Max{});
        case Op::sqrt_:
            return floats<T>([](T x) { return std::sqrt(x); });
        case Op::inversesqrt_:
            return floats<T>([](T x) { return 1 / std::sqrt(x); });
        default:
            return nullptr;
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
StepKernel<T> shaping(Op op) {
    switch (op) {
        case Op::abs_:
            return floats<T>([](T x) { return std::fabs(x); });
        case Op::sign_:
            return floats<T>([](T x) { return T(x > 0) - T(x < 0); });
        case Op::sign_nonzero_:
            return floats<T>([](T x) { return x < 0 ? T(-1) : T(1); });
        case Op::floor_:
            return floats<T>([](T x) { return math::floor(x); });
        case Op::ceil_:
            return floats<T>([](T x) { return -math::floor(-x); });
        case Op::fract_:
            return floats<T>([](T x) { return x - math::floor(x); });
        case Op::clamp_:
            return floats<T>([](T x, T a, T b) { return clamped(x, a, b); });
        case Op::step_:
            return floats<T>([](T e, T x) { return x < e ? T(0) : T(1); });
        case Op::smoothstep_:
            return floats<T>([](T a, T b, T x) { return smoothstep(a, b, x); });
        default:
            return nullptr;
    }
}

template <class T>
StepKernel<T> transcendental(Op op) {
    switch (op) {
        case Op::pow_:
            return floats<T>([](T x, T y) { return math::pow(x, y); });
        case Op::exp_:
            return floats<T>([](T x) { return math::exp(x); });
        case Op::log_:
            return floats<T>([](T x) { return math::log(x); });
        case Op::exp2_:
            return floats<T>([](T x) { return math::exp2(x); });
        case Op::log2_:
            return floats<T>([](T x) { return math::log2(x); });
        case Op::sin_:
            return floats<T>([](T x) { return math::sin(x); });
        case Op::cos_:
            return floats<T>([](T x) { return math::cos(x); });
        case Op::tan_:
            return floats<T>([](T x) { return math::tan(x); });
        case Op::asin_:
            return floats<T>([](T x) { return math::asin(x); });
        case Op::acos_:
            return floats<T>([](T x) { return math::acos(x); });
        case Op::atan_:
            return floats<T>([](T x) { return math::atan(x); });
        case Op::atan2_:
            return floats<T>([](T y, T x) { return math::atan2(y, x); });
        default:
            return nullptr;
    }
}

// A is the type of the operands.
template <class T, class A>
StepKernel<T> comparison(Op op) {
    switch (op) {
        case Op::lt_:
            return on<T, A, uint32_t>([](A x, A y) { return uint32_t(x < y); });
        case Op::le_:
            return on<T, A, uint32_t>([](A x, A y) { return uint32_t(x <= y); });
        case Op::gt_:
            return on<T, A, uint32_t>([](A x, A y) { return uint32_t(x > y); });
        case Op::ge_:
            return on<T, A, uint32_t>([](A x, A y) { return uint32_t(x >= y); });
        case Op::eq_:
            return on<T, A, uint32_t>([](A x, A y) { return uint32_t(x == y); });
        case Op::ne_:
            return on<T, A, uint32_t>([](A x, A y) { return uint32_t(x != y); });
        default:
            return nullptr;
    }
}

// Ops that are the same for int and uint in two's complement.
template <class T>
StepKernel<T> words(Op op) {
    using W = uint32_t;
    switch (op) {
        case Op::neg_:
            return integers<T>([](W x) { return 0u - x; });
        case Op::add_:
            return integers<T>([](W x, W y) { return x + y; });
        case Op::sub_:
            return integers<T>([](W x, W y) { return x - y; });
        case Op::mul_:
            return integers<T>([](W x, W y) { return x * y; });
        case Op::and_:
        case Op::bit_and_:
            return integers<T>([](W x, W y) { return x & y; });
        case Op::or_:
        case Op::bit_or_:
            return integers<T>([](W x, W y) { return x | y; });
        case Op::bit_xor_:
            return integers<T>([](W x, W y) { return x ^ y; });
        case Op::not_:
            return integers<T>([](W x) { return x ^ 1u; });
        case Op::shift_left_:
            return integers<T>([](W x, W y) { return x << (y & 31); });
        case Op::to_int_:
        case Op::to_uint_:
            return integers<T>([](W x) { return x; });
        default:
            return nullptr;
    }
}

// Ops that depend on the sign; S is int32_t or uint32_t.
template <class T, class S>
StepKernel<T> ordered(Op op) {
    switch (op) {
        case Op::min_:
            return on<T, S, S>([](S x, S y) { return y < x ? y : x; });
        case Op::max_:
            return on<T, S, S>([](S x, S y) { return x < y ? y : x; });
        case Op::shift_right_:
            return on<T, S, S>([](S x, S y) { return x >> (y & 31); });
        default:
            return nullptr;
    }
}

// Rounds towards zero; values out of range become the nearest int that T represents, NaN becomes 0.
template <class T>
uint32_t truncated(T x) {
    constexpr T low = T(-2147483648.0), high = sizeof(T) == 4 ? T(2147483520.0) : T(2147483647.0);
    return static_cast<uint32_t>(static_cast<int32_t>(clamped(x == x ? x : T(0), low, high)));
}

template <class T>
StepKernel<T> on_floats(Op op) {
    if (op == Op::select_) return select<T, T>;
    if (op == Op::to_int_) return on<T, T, uint32_t>([](T x) { return truncated(x); });
    for (const auto family :
         {arithmetic<T>, shaping<T>, transcendental<T>, comparison<T, T>, of_vectors<T>})
        if (const StepKernel<T> kernel = family(op)) return kernel;
    return nullptr;
}

template <class T, class S>
StepKernel<T> on_integers(Op op) {
    if (op == Op::select_) return select<T, uint32_t>;
    if (op == Op::to_float_) return on<T, S, T>([](S x) { return static_cast<T>(x); });
    for (const auto family : {words<T>, ordered<T, S>, comparison<T, S>})
        if (const StepKernel<T> kernel = family(op)) return kernel;
    return nullptr;
}

template <class T>
[[gnu::noinline]] StepKernel<T> kernel_of(Op op, Type type) {
    if (type == Type::float_) return on_floats<T>(op);
    return type == Type::int_ ? on_integers<T, int32_t>(op) : on_integers<T, uint32_t>(op);
}

// Called once per process: optimised for size, not for speed.
template <class T>
[[gnu::cold]] StepLoops<T> make_loops() {
    StepLoops<T> loops{};
    for (const Type type : {Type::float_, Type::int_, Type::uint_})
        for (size_t op = 0; op < tables::op_count; ++op)
            loops[op_loop(static_cast<Op>(op), type)] = kernel_of<T>(static_cast<Op>(op), type);
    for (const Op first : first_ops)
        for (const Op second : second_ops)
            for (const bool swapped : {false, true})
                loops[pair_loop(first, second, swapped)] = pair_kernel<T>(first, second, swapped);
    loops[depth_loop] = depth<T>;
    return loops;
}

template <class T>
const StepLoops<T>& loops() {
    static const StepLoops<T> made = make_loops<T>();
    return made;
}

}  // namespace

const Kernels kernels = {loops<float>, loops<double>, sample_level, interpolate};

}  // namespace wrinkle::WRINKLE_ISA
