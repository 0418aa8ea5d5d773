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
void pair(const Step& step, const Registers<T>& registers, size_t n) {
    const T *a = lanes_of<T>(registers, step.in[0]), *b = lanes_of<T>(registers, step.in[1]),
            *c = lanes_of<T>(registers, step.in[2]);
    T* __restrict out = lanes_of<T>(registers, step.out[0]);
    WRINKLE_LANES
    for (size_t k = 0; k < n; ++k) {
        const T x = First{}(a[k], b[k]);
        out[k] = swapped ? Second{}(c[k], x) : Second{}(x, c[k]);
    }
}

template <class T>
void depth(const Step& step, const Registers<T>& registers, size_t n) {
    const T* in[5];
    for (size_t i = 0; i < 5; ++i)
        in[i] = lanes_of<T>(registers, step.in[i]);
    T* __restrict out = lanes_of<T>(registers, step.out[0]);
    WRINKLE_LANES
    for (size_t k = 0; k < n; ++k) {
        const T least = max_{}(std::fabs(in[0][k]), std::fabs(in[1][k])) * in[2][k];
        out[k] = max_{}(max_{}(std::fabs(in[3][k]), least), in[4][k]);
    }
}

template <class T, class First, class Second>
StepKernel<T> pair_of(bool swapped) {
    return swapped ? pair<T, First, Second, true> : pair<T, First, Second, false>;
}

template <class T, class First>
StepKernel<T> pair_with(Op second, bool swapped) {
    switch (second) {
        case Op::add_:
            return pair_of<T, First, add_>(swapped);
        case Op::sub_:
            return pair_of<T, First, sub_>(swapped);
        case Op::mul_:
            return pair_of<T, First, mul_>(swapped);
        case Op::min_:
            return pair_of<T, First, min_>(swapped);
        case Op::max_:
            return pair_of<T, First, max_>(swapped);
        default:
            return nullptr;
    }
}

template <class T>
[[gnu::noinline]] StepKernel<T> pair_kernel(Op first, Op second, bool swapped) {
    switch (first) {
        case Op::abs_:
            return pair_with<T, AbsOfFirst>(second, swapped);
        case Op::add_:
            return pair_with<T, add_>(second, swapped);
        case Op::sub_:
            return pair_with<T, sub_>(second, swapped);
        case Op::mul_:
            return pair_with<T, mul_>(second, swapped);
        case Op::min_:
            return pair_with<T, min_>(second, swapped);
        case Op::max_:
            return pair_with<T, max_>(second, swapped);
        default:
            return nullptr;
    }
}

// Dot product of two or three components, summed in order of the components.
template <class T>
void dot(const Step& step, const Registers<T>& registers, size_t n) {
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
void cross(const Step& step, const Registers<T>& registers, size_t n) {
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
void normalize(const Step& step, const Registers<T>& registers, size_t n) {
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

template <class T>
StepKernel<T> of_vectors(Op op) {
    switch (op) {
        case Op::dot_:
            return dot<T>;
        case Op::cross_:
            return cross<T>;
        case Op::normalize_:
            return normalize<T>;
        default:
            return nullptr;
    }
}

}  // namespace
}  // namespace wrinkle::WRINKLE_ISA
