// Kernels of kernels.h, included once per instruction set. A step's output register is never one of
// its operands (registers.cpp), so the loops vectorise.
#ifndef WRINKLE_ISA
#error "say for which instruction set: define WRINKLE_ISA"
#endif

#include <cmath>
#include <type_traits>

#include "base/srgb.h"
#include "cpu/fused_bodies.h"
#include "cpu/kernels.h"
#include "cpu/sample_bodies.h"
#include "ir/op_meaning.h"
// Included after sample_bodies.h, which includes vectors.h.
#include "cpu/interpolate_bodies.h"

namespace wrinkle::WRINKLE_ISA {
namespace {

// Computes out = f(a), f(a, b) or f(a, b, c) on every lane.
template <class T, class A, class Out, class F>
void each(const CpuInst& step, const Registers<T>& registers, size_t n) {
    Out* out = lanes_of<Out>(registers, step.out[0]);
    const auto operand = [&](size_t i) { return Operand<A>(step, registers, i); };
    const auto set = [=](size_t k, auto... values) { out[k] = F{}(values...); };
    if constexpr (std::is_invocable_v<F, A>)
        each_lane(n, set, operand(0));
    else if constexpr (std::is_invocable_v<F, A, A>)
        each_lane(n, set, operand(0), operand(1));
    else
        each_lane(n, set, operand(0), operand(1), operand(2));
}

template <class T, class A, class Out>
constexpr auto kernel_for = []<class F>(F) -> InstKernel<T> { return each<T, A, Out, F>; };

template <class T, class Lane>
void select(const CpuInst& step, const Registers<T>& registers, size_t n) {
    Lane* out = lanes_of<Lane>(registers, step.out[0]);
    each_lane(
        n, [=](size_t k, uint32_t condition, Lane a, Lane b) { out[k] = condition ? a : b; },
        Operand<uint32_t>(step, registers, 0), Operand<Lane>(step, registers, 1),
        Operand<Lane>(step, registers, 2));
}

template <class T, class Lane>
void move(const CpuInst& step, const Registers<T>& registers, size_t n) {
    Lane* out = lanes_of<Lane>(registers, step.out[0]);
    each_lane(
        n, [=](size_t k, Lane from) { out[k] = from; }, Operand<Lane>(step, registers, 0));
}

template <class T, class Lane>
void masked_move(const CpuInst& step, const Registers<T>& registers, size_t n) {
    Lane* out = lanes_of<Lane>(registers, step.out[0]);
    const uint32_t* active = registers.active;
    each_lane(
        n, [=](size_t k, Lane from) { out[k] = active[k] ? from : out[k]; },
        Operand<Lane>(step, registers, 0));
}

// Rounds towards zero; values out of range become the nearest int that T represents, NaN becomes 0.
template <class T>
uint32_t truncated(T x) {
    constexpr T low = T(-2147483648.0), high = sizeof(T) == 4 ? T(2147483520.0) : T(2147483647.0);
    return static_cast<uint32_t>(
        static_cast<int32_t>(meaning::clamped(x == x ? x : T(0), low, high)));
}

template <class T>
InstKernel<T> on_floats(Op op) {
    if (op == Op::select_) return select<T, T>;
    if (op == Op::sin_) return sine_cosine<T>;
    if (op == Op::to_int_) return kernel_for<T, T, uint32_t>([](T x) { return truncated(x); });
    if (const auto found = meaning::floats::find<InstKernel<T>>(op, kernel_for<T, T, T>))
        return found;
    if (const auto found =
            meaning::comparisons::find<InstKernel<T>>(op, kernel_for<T, T, uint32_t>))
        return found;
    if (op == Op::dot_) return dot<T>;
    if (op == Op::cross_) return cross<T>;
    return op == Op::normalize_ ? normalize<T> : nullptr;
}

template <class T, class S>
InstKernel<T> on_integers(Op op) {
    using Word = uint32_t;
    if (op == Op::select_) return select<T, Word>;
    if (op == Op::to_float_) return kernel_for<T, S, T>([](S x) { return static_cast<T>(x); });
    if (op == Op::to_int_ || op == Op::to_uint_)
        return kernel_for<T, Word, Word>([](Word x) { return x; });
    if (const auto found = meaning::words::find<InstKernel<T>>(op, kernel_for<T, Word, Word>))
        return found;
    if (const auto found = meaning::ordered::find<InstKernel<T>>(op, kernel_for<T, S, S>))
        return found;
    return meaning::comparisons::find<InstKernel<T>>(op, kernel_for<T, S, Word>);
}

template <class T>
[[gnu::noinline]] InstKernel<T> kernel_of(Op op, Type type) {
    if (type == Type::float_) return on_floats<T>(op);
    return type == Type::int_ ? on_integers<T, int32_t>(op) : on_integers<T, uint32_t>(op);
}

// Called once per process: optimised for size, not for speed.
template <class T>
[[gnu::cold]] KernelTable<T> make_kernel_table() {
    KernelTable<T> table{};
    for (const Type type : {Type::float_, Type::int_, Type::uint_})
        for (size_t op = 0; op < tables::op_count; ++op)
            table[op_kernel(static_cast<Op>(op), type)] = kernel_of<T>(static_cast<Op>(op), type);
    add_pairs<T>(table);
    add_word_pairs<T>(table);
    table[hash_kernel] = kernel_for<T, uint32_t, uint32_t>([](uint32_t x) { return pcg_hash(x); });
    table[move_kernel(Type::float_, false)] = move<T, T>;
    table[move_kernel(Type::float_, true)] = masked_move<T, T>;
    table[move_kernel(Type::uint_, false)] = move<T, uint32_t>;
    table[move_kernel(Type::uint_, true)] = masked_move<T, uint32_t>;
    return table;
}

template <class T>
const KernelTable<T>& kernels_of_type() {
    static const KernelTable<T> made = make_kernel_table<T>();
    return made;
}

void encode_srgb(float* values, size_t n) {
    for (size_t i = 0; i < n; ++i)
        values[i] = static_cast<float>(srgb_from_linear(static_cast<double>(values[i])));
}

}  // namespace

const Kernels kernels = {kernels_of_type<float>, kernels_of_type<double>, sample_level, interpolate,
                         encode_srgb};

}  // namespace wrinkle::WRINKLE_ISA
