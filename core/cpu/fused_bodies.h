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

// The lanes of an operand, block by block; those of a uniform register are one block.
template <class Lane>
struct Operand {
    const Lane* block;
    size_t stride;

    template <class T>
    Operand(const CpuInst& step, const Registers<T>& registers, size_t i)
        : block(lanes_of<Lane>(registers, step.in[i])),
          stride(step.uniform >> i & 1 ? 0 : block_lanes) {}
};

// Calls f(lane, value of each operand) for n lanes.
template <class F, class... Lane>
[[gnu::always_inline]] inline void each_lane(size_t n, F f, Operand<Lane>... operands) {
    for (size_t first = 0; first < n; first += block_lanes) {
        WRINKLE_LANES
        for (size_t k = 0; k < block_lanes; ++k)
            f(first + k, operands.block[k]...);
        ((operands.block += operands.stride), ...);
    }
}

using meaning::floats::add_, meaning::floats::sub_, meaning::floats::mul_, meaning::floats::min_,
    meaning::floats::max_;
struct AbsOfFirst {
    template <class T>
    T operator()(T x, T) const {
        return std::fabs(x);
    }
};

// Lane is T, or uint32_t for integers.
template <class T, class Lane, class First, class Second, bool swapped>
void pair(const CpuInst& step, const Registers<T>& registers, size_t n) {
    Lane* out = lanes_of<Lane>(registers, step.out[0]);
    const auto joined = [=](size_t k, Lane a, Lane b, Lane c) {
        const Lane x = First{}(a, b);
        out[k] = swapped ? Second{}(c, x) : Second{}(x, c);
    };
    each_lane(n, joined, Operand<Lane>(step, registers, 0), Operand<Lane>(step, registers, 1),
              Operand<Lane>(step, registers, 2));
}

// The first op converts from uint.
template <class T, class Second, bool swapped>
void converted(const CpuInst& step, const Registers<T>& registers, size_t n) {
    T* out = lanes_of<T>(registers, step.out[0]);
    const auto joined = [=](size_t k, uint32_t a, T c) {
        const T x = static_cast<T>(a);
        out[k] = swapped ? Second{}(c, x) : Second{}(x, c);
    };
    each_lane(n, joined, Operand<uint32_t>(step, registers, 0), Operand<T>(step, registers, 2));
}

// Enters the kernels of all pairs of first_ops and second_ops.
template <class T>
void add_pairs(KernelTable<T>& table) {
    const auto add = [&]<class First, class Second>(Op first, First, Op second, Second) {
        table[fused_kernel(first, second, false)] = pair<T, T, First, Second, false>;
        table[fused_kernel(first, second, true)] = pair<T, T, First, Second, true>;
        table[fused_kernel(Op::to_float_, second, false)] = converted<T, Second, false>;
        table[fused_kernel(Op::to_float_, second, true)] = converted<T, Second, true>;
    };
    const auto add_all = [&](Op first, auto make) {
        add(first, make, Op::add_, add_{});
        add(first, make, Op::sub_, sub_{});
        add(first, make, Op::mul_, mul_{});
        add(first, make, Op::min_, min_{});
        add(first, make, Op::max_, max_{});
    };
    add_all(Op::abs_, AbsOfFirst{});
    add_all(Op::add_, add_{});
    add_all(Op::sub_, sub_{});
    add_all(Op::mul_, mul_{});
    add_all(Op::min_, min_{});
    add_all(Op::max_, max_{});
}

// The same for the ops of integers, as in hashes.
template <class T>
void add_word_pairs(KernelTable<T>& table) {
    using Word = uint32_t;
    namespace words = meaning::words;
    const auto add = [&]<class First, class Second>(Op first, First, Op second, Second) {
        table[fused_word_kernel(first, second, false)] = pair<T, Word, First, Second, false>;
        table[fused_word_kernel(first, second, true)] = pair<T, Word, First, Second, true>;
    };
    const auto add_all = [&](Op first, auto make) {
        add(first, make, Op::add_, words::add_{});
        add(first, make, Op::mul_, words::mul_{});
        add(first, make, Op::bit_and_, words::bit_and_{});
        add(first, make, Op::bit_xor_, words::bit_xor_{});
        add(first, make, Op::shift_right_, meaning::ordered::shift_right_{});
    };
    add_all(Op::add_, words::add_{});
    add_all(Op::mul_, words::mul_{});
    add_all(Op::bit_and_, words::bit_and_{});
    add_all(Op::bit_xor_, words::bit_xor_{});
    add_all(Op::shift_right_, meaning::ordered::shift_right_{});
}

uint32_t pcg_hash(uint32_t x) {
    constexpr PcgConstants pcg;
    const uint32_t sum = x * pcg.multiplier + pcg.increment;
    const uint32_t mixed = (sum >> ((sum >> pcg.shift) + pcg.least_shift)) ^ sum;
    const uint32_t product = mixed * pcg.factor;
    return (product >> pcg.last_shift) ^ product;
}

// Dot product of two or three components, summed in order of the components.
template <class T>
void dot(const CpuInst& step, const Registers<T>& registers, size_t n) {
    T* out = lanes_of<T>(registers, step.out[0]);
    const auto operand = [&](size_t i) { return Operand<T>(step, registers, i); };
    if (step.count == 4)
        return each_lane(
            n, [=](size_t k, T ax, T ay, T bx, T by) { out[k] = ax * bx + ay * by; }, operand(0),
            operand(1), operand(2), operand(3));
    const auto sum = [=](size_t k, T ax, T ay, T az, T bx, T by, T bz) {
        out[k] = ax * bx + ay * by + az * bz;
    };
    each_lane(n, sum, operand(0), operand(1), operand(2), operand(3), operand(4), operand(5));
}

// The sine and the cosine, which share the reduction of the angle and two series.
template <class T>
void sine_cosine(const CpuInst& step, const Registers<T>& registers, size_t n) {
    T* sine = lanes_of<T>(registers, step.out[0]);
    T* cosine = lanes_of<T>(registers, step.out[1]);
    const auto both = [=](size_t k, T x) {
        sine[k] = math::sin(x);
        cosine[k] = math::cos(x);
    };
    each_lane(n, both, Operand<T>(step, registers, 0));
}

template <class T>
void cross(const CpuInst& step, const Registers<T>& registers, size_t n) {
    T* x = lanes_of<T>(registers, step.out[0]);
    T* y = lanes_of<T>(registers, step.out[1]);
    T* z = lanes_of<T>(registers, step.out[2]);
    const auto product = [=](size_t k, T ax, T ay, T az, T bx, T by, T bz) {
        x[k] = ay * bz - az * by;
        y[k] = az * bx - ax * bz;
        z[k] = ax * by - ay * bx;
    };
    const auto operand = [&](size_t i) { return Operand<T>(step, registers, i); };
    each_lane(n, product, operand(0), operand(1), operand(2), operand(3), operand(4), operand(5));
}

// Multiplies two or three components by the reciprocal of their length.
template <class T>
void normalize(const CpuInst& step, const Registers<T>& registers, size_t n) {
    T* x = lanes_of<T>(registers, step.out[0]);
    T* y = lanes_of<T>(registers, step.out[1]);
    T* z = lanes_of<T>(registers, step.out[2]);
    const auto operand = [&](size_t i) { return Operand<T>(step, registers, i); };
    const auto of_two = [=](size_t k, T a, T b) {
        const T scale = 1 / std::sqrt(a * a + b * b);
        x[k] = a * scale;
        y[k] = b * scale;
    };
    if (step.count == 2) return each_lane(n, of_two, operand(0), operand(1));
    const auto of_three = [=](size_t k, T a, T b, T c) {
        const T scale = 1 / std::sqrt(a * a + b * b + c * c);
        x[k] = a * scale;
        y[k] = b * scale;
        z[k] = c * scale;
    };
    each_lane(n, of_three, operand(0), operand(1), operand(2));
}

}  // namespace
}  // namespace wrinkle::WRINKLE_ISA
