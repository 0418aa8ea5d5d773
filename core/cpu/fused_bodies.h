// Kernels that compute several ops in one pass over memory, and helpers shared by all kernels; see
// kernels.h.
#ifndef WRINKLE_ISA
#error "say for which instruction set: define WRINKLE_ISA"
#endif

#include <cmath>
#include <type_traits>

#include "cpu/kernels.h"
#include "ir/op_meaning.h"

// Precondition: outputs do not overlap operands (registers.cpp).
#if defined(__clang__)
#define WRINKLE_LANES _Pragma("clang loop vectorize(assume_safety)")
#else
#define WRINKLE_LANES _Pragma("GCC ivdep")
#endif

namespace wrinkle::WRINKLE_ISA {
namespace {

template <class Lane, class T>
Lane* lanes_of(const Registers<T>& registers, uint32_t reg) {
    if constexpr (std::is_same_v<Lane, T>)
        return registers.floats[reg];
    else
        return reinterpret_cast<Lane*>(registers.integers[reg]);
}

using meaning::floats::add_, meaning::floats::sub_, meaning::floats::mul_, meaning::floats::min_,
    meaning::floats::max_;
struct AbsOfFirst {
    template <class T>
    T operator()(T x, T) const {
        return std::fabs(x);
    }
};

template <class T, class First, class Second, bool swapped>
void pair(const CpuInst& step, const Registers<T>& registers, size_t n) {
    const T *a = lanes_of<T>(registers, step.in[0]), *b = lanes_of<T>(registers, step.in[1]),
            *c = lanes_of<T>(registers, step.in[2]);
    T* __restrict out = lanes_of<T>(registers, step.out[0]);
    WRINKLE_LANES
    for (size_t k = 0; k < n; ++k) {
        const T x = First{}(a[k], b[k]);
        out[k] = swapped ? Second{}(c[k], x) : Second{}(x, c[k]);
    }
}

template <class T, class First>
void add_pairs(KernelTable<T>& table, Op first) {
    const auto add = [&]<class Second>(Op second, Second) {
        table[fused_kernel(first, second, false)] = pair<T, First, Second, false>;
        table[fused_kernel(first, second, true)] = pair<T, First, Second, true>;
    };
    add(Op::add_, add_{});
    add(Op::sub_, sub_{});
    add(Op::mul_, mul_{});
    add(Op::min_, min_{});
    add(Op::max_, max_{});
}

// Enters the kernels of all pairs of first_ops and second_ops.
template <class T>
void add_pairs(KernelTable<T>& table) {
    add_pairs<T, AbsOfFirst>(table, Op::abs_);
    add_pairs<T, add_>(table, Op::add_);
    add_pairs<T, sub_>(table, Op::sub_);
    add_pairs<T, mul_>(table, Op::mul_);
    add_pairs<T, min_>(table, Op::min_);
    add_pairs<T, max_>(table, Op::max_);
}

// Dot product of two or three components, summed in order of the components.
template <class T>
void dot(const CpuInst& step, const Registers<T>& registers, size_t n) {
    const T *a[3], *b[3];
    const size_t lanes = step.count / 2;
    for (size_t i = 0; i < 3; ++i) {
        a[i] = lanes_of<T>(registers, step.in[i]);
        b[i] = lanes_of<T>(registers, step.in[lanes + i % lanes]);
    }
    T* __restrict out = lanes_of<T>(registers, step.out[0]);
    if (lanes == 2) WRINKLE_LANES
    for (size_t k = 0; k < n; ++k)
        out[k] = a[0][k] * b[0][k] + a[1][k] * b[1][k];
    else WRINKLE_LANES for (size_t k = 0; k < n; ++k) out[k] =
        a[0][k] * b[0][k] + a[1][k] * b[1][k] + a[2][k] * b[2][k];
}

template <class T>
void cross(const CpuInst& step, const Registers<T>& registers, size_t n) {
    const T* in[6];
    for (size_t i = 0; i < 6; ++i)
        in[i] = lanes_of<T>(registers, step.in[i]);
    T* __restrict x = lanes_of<T>(registers, step.out[0]);
    T* __restrict y = lanes_of<T>(registers, step.out[1]);
    T* __restrict z = lanes_of<T>(registers, step.out[2]);
    WRINKLE_LANES
    for (size_t k = 0; k < n; ++k) {
        x[k] = in[1][k] * in[5][k] - in[2][k] * in[4][k];
        y[k] = in[2][k] * in[3][k] - in[0][k] * in[5][k];
        z[k] = in[0][k] * in[4][k] - in[1][k] * in[3][k];
    }
}

// Multiplies two or three components by the reciprocal of their length.
template <class T>
void normalize(const CpuInst& step, const Registers<T>& registers, size_t n) {
    const size_t last = step.count - 1u;
    const T *a = lanes_of<T>(registers, step.in[0]), *b = lanes_of<T>(registers, step.in[1]),
            *c = lanes_of<T>(registers, step.in[last]);
    T* __restrict x = lanes_of<T>(registers, step.out[0]);
    T* __restrict y = lanes_of<T>(registers, step.out[1]);
    T* __restrict z = lanes_of<T>(registers, step.out[last]);
    if (step.count == 2) WRINKLE_LANES
    for (size_t k = 0; k < n; ++k) {
        const T scale = 1 / std::sqrt(a[k] * a[k] + b[k] * b[k]);
        x[k] = a[k] * scale;
        y[k] = b[k] * scale;
    }
    else WRINKLE_LANES for (size_t k = 0; k < n; ++k) {
        const T scale = 1 / std::sqrt(a[k] * a[k] + b[k] * b[k] + c[k] * c[k]);
        x[k] = a[k] * scale;
        y[k] = b[k] * scale;
        z[k] = c[k] * scale;
    }
}

}  // namespace
}  // namespace wrinkle::WRINKLE_ISA
