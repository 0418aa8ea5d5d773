#include "ir/add.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "ir/op_meaning.h"

namespace wrinkle {
namespace {

using Constants = std::span<const Constant>;

uint32_t word_of(double x) {
    return static_cast<uint32_t>(static_cast<int64_t>(x));
}
double number_of(Type type, uint32_t word) {
    if (type == Type::int_) return static_cast<int32_t>(word);
    return word;
}

// Calls f with as many of the operands as it takes.
template <class T, class F>
auto apply(F f, T a, T b, T c) {
    if constexpr (std::is_invocable_v<F, T>)
        return f(a);
    else if constexpr (std::is_invocable_v<F, T, T>)
        return f(a, b);
    else
        return f(a, b, c);
}

// Results outside an op's domain are not finite, except those of these ops.
bool in_domain(Op op, double a, double b) {
    if (op == Op::pow_) return a > 0 || (a == 0 && b > 0);
    if (op == Op::atan2_) return a != 0 || b != 0;
    return op != Op::smoothstep_ || a < b;
}

using Folded = std::optional<double>;

Folded fold_float(Op op, double a, double b, double c) {
    if (!in_domain(op, a, b)) return {};
    const Folded folded =
        meaning::floats::find<Folded>(op, [&](auto f) { return apply(f, a, b, c); });
    // The angle of a quarter turn is rounded, so its sine or cosine is not exactly 0.
    const bool is_turn = (op == Op::sin_ || op == Op::cos_) && std::fabs(a) > 1;
    return is_turn && std::fabs(*folded) < 1e-15 ? Folded(0) : folded;
}

Folded fold_whole(Op op, Type type, double a, double b) {
    const auto on_words = [&](auto f) {
        return number_of(type, apply(f, word_of(a), word_of(b), 0U));
    };
    const auto in_order = [&](auto f) -> double {
        if (type == Type::int_)
            return apply(f, static_cast<int32_t>(a), static_cast<int32_t>(b), 0);
        return apply(f, word_of(a), word_of(b), 0U);
    };
    if (b < 0 || b > 31)
        if (op == Op::shift_left_ || op == Op::shift_right_) return {};
    if (const auto folded = meaning::words::find<Folded>(op, on_words)) return folded;
    return meaning::ordered::find<Folded>(op, in_order);
}

Folded fold_conversion(Op op, const Constant& from) {
    const double a = from.lanes[0];
    if (op == Op::to_float_) return a;
    if (op == Op::to_uint_) return word_of(a);
    if (from.type == Type::uint_) return number_of(Type::int_, word_of(a));
    const double whole = std::trunc(a);
    if (whole < -2147483648.0 || whole > 2147483647.0) return {};
    return whole;
}

Folded fold_lane(Op op, Type type, Constants x, size_t lane) {
    if (op == Op::to_float_ || op == Op::to_int_ || op == Op::to_uint_)
        return fold_conversion(op, x[0]);
    double v[3] = {};
    for (size_t i = 0; i < x.size() && i < 3; ++i)
        v[i] = x[i].lanes[info(x[i].type).lanes > 1 ? lane : 0];
    if (info(op).rule == Rule::compare)
        return meaning::comparisons::find<Folded>(op, [&](auto f) { return f(v[0], v[1]); });
    return is_whole_type(type) ? fold_whole(op, type, v[0], v[1])
                               : fold_float(op, v[0], v[1], v[2]);
}

double dot(const Constant& a, const Constant& b) {
    double sum = 0;
    for (size_t i = 0; i < info(a.type).lanes; ++i)
        sum += a.lanes[i] * b.lanes[i];
    return sum;
}

bool fold_vector(Op op, Constants x, Lanes& r) {
    const Lanes& a = x[0].lanes;
    const size_t n = info(x[0].type).lanes;
    switch (op) {
        case Op::dot_:
            r[0] = dot(x[0], x[1]);
            return true;
        case Op::length_:
            r[0] = std::sqrt(dot(x[0], x[0]));
            return true;
        case Op::normalize_: {
            const double length = std::sqrt(dot(x[0], x[0]));
            for (size_t i = 0; i < n; ++i)
                r[i] = a[i] / length;
            return length > 0;
        }
        case Op::reflect_:
            for (size_t i = 0; i < n; ++i)
                r[i] = a[i] - 2 * dot(x[1], x[0]) * x[1].lanes[i];
            return true;
        case Op::cross_: {
            const Lanes& b = x[1].lanes;
            r = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
            return true;
        }
        case Op::transpose_:
            for (size_t i = 0; i < 9; ++i)
                r[i] = a[i % 3 * 3 + i / 3];
            return true;
        case Op::transform_:
        case Op::matrix_product_: {
            const size_t columns = info(x[1].type).lanes / 3;
            for (size_t c = 0; c < columns; ++c)
                for (size_t i = 0; i < 3; ++i) {
                    const double* column = x[1].lanes.data() + c * 3;
                    r[c * 3 + i] = a[i] * column[0] + a[3 + i] * column[1] + a[6 + i] * column[2];
                }
            return true;
        }
        default:
            return false;
    }
}

}  // namespace

bool fold(Op op, Type result, uint32_t extra, Constants operands, Lanes& lanes) {
    if (operands.empty()) return false;
    if (op == Op::column_)
        std::copy_n(operands[0].lanes.begin() + extra * 3, 3, lanes.begin());
    else if (!fold_vector(op, operands, lanes))
        for (size_t lane = 0; lane < info(result).lanes; ++lane) {
            const Folded folded = fold_lane(op, result, operands, lane);
            if (!folded) return false;
            lanes[lane] = *folded;
        }
    return std::all_of(lanes.begin(), lanes.begin() + info(result).lanes,
                       [](double lane) { return std::isfinite(lane); });
}

}  // namespace wrinkle
