#include "ir/fold.h"

#include <cmath>
#include <cstdint>

#include "base/transcendental.h"

namespace wrinkle {
namespace {

using Constants = std::span<const Constant>;

double wrapped(Type type, int64_t value) {
    if (type == Type::uint_) return static_cast<double>(static_cast<uint32_t>(value));
    return static_cast<double>(static_cast<int32_t>(static_cast<uint32_t>(value)));
}

bool fold_integer(Op op, Type type, double x, double y, double& r) {
    const auto a = static_cast<int64_t>(x), b = static_cast<int64_t>(y);
    switch (op) {
        case Op::neg_:
            r = wrapped(type, -a);
            return true;
        case Op::add_:
            r = wrapped(type, a + b);
            return true;
        case Op::sub_:
            r = wrapped(type, a - b);
            return true;
        case Op::mul_:
            r = wrapped(type,
                        static_cast<int64_t>(static_cast<uint64_t>(a) * static_cast<uint64_t>(b)));
            return true;
        case Op::min_:
            r = static_cast<double>(b < a ? b : a);
            return true;
        case Op::max_:
            r = static_cast<double>(a < b ? b : a);
            return true;
        case Op::bit_and_:
            r = wrapped(type, a & b);
            return true;
        case Op::bit_or_:
            r = wrapped(type, a | b);
            return true;
        case Op::bit_xor_:
            r = wrapped(type, a ^ b);
            return true;
        case Op::shift_left_:
            if (b < 0 || b > 31) return false;
            r = wrapped(type, static_cast<int64_t>(static_cast<uint64_t>(a) << b));
            return true;
        case Op::shift_right_:
            if (b < 0 || b > 31) return false;
            r = wrapped(type, a >> b);
            return true;
        default:
            return false;
    }
}

bool fold_range(Op op, double a, double b, double c, double& r) {
    switch (op) {
        case Op::min_:
            r = b < a ? b : a;
            return true;
        case Op::max_:
            r = a < b ? b : a;
            return true;
        case Op::clamp_: {
            const double low = a < b ? b : a;
            r = c < low ? c : low;
            return true;
        }
        case Op::mix_:
            r = a * (1 - c) + b * c;
            return true;
        case Op::step_:
            r = b < a ? 0 : 1;
            return true;
        case Op::smoothstep_: {
            if (!(a < b)) return false;
            double t = (c - a) / (b - a);
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            r = t * t * (3 - 2 * t);
            return true;
        }
        default:
            return false;
    }
}

bool fold_arithmetic(Op op, double a, double b, double c, double& r) {
    switch (op) {
        case Op::neg_:
            r = -a;
            return true;
        case Op::add_:
            r = a + b;
            return true;
        case Op::sub_:
            r = a - b;
            return true;
        case Op::mul_:
            r = a * b;
            return true;
        case Op::div_:
            r = a / b;
            return b != 0;
        case Op::mod_:
            r = a - b * std::floor(a / b);
            return b != 0;
        case Op::abs_:
            r = std::fabs(a);
            return true;
        case Op::sign_:
            r = a > 0 ? 1 : a < 0 ? -1 : 0;
            return true;
        case Op::sign_nonzero_:
            r = a >= 0 ? 1 : -1;
            return true;
        case Op::floor_:
            r = std::floor(a);
            return true;
        case Op::ceil_:
            r = std::ceil(a);
            return true;
        case Op::fract_:
            r = a - std::floor(a);
            return true;
        default:
            return fold_range(op, a, b, c, r);
    }
}

bool fold_transcendental(Op op, double a, double b, double& r) {
    switch (op) {
        case Op::sqrt_:
            r = std::sqrt(a);
            return a >= 0;
        case Op::inversesqrt_:
            r = 1 / std::sqrt(a);
            return a > 0;
        case Op::pow_:
            r = math::pow(a, b);
            return a > 0 || (a == 0 && b > 0);
        case Op::exp_:
            r = math::exp(a);
            return true;
        case Op::log_:
            r = math::log(a);
            return a > 0;
        case Op::exp2_:
            r = math::exp2(a);
            return true;
        case Op::log2_:
            r = math::log2(a);
            return a > 0;
        case Op::sin_:
            r = math::sin(a);
            return true;
        case Op::cos_:
            r = math::cos(a);
            return true;
        case Op::tan_:
            r = math::tan(a);
            return true;
        case Op::asin_:
            r = math::asin(a);
            return a >= -1 && a <= 1;
        case Op::acos_:
            r = math::acos(a);
            return a >= -1 && a <= 1;
        case Op::atan_:
            r = math::atan(a);
            return true;
        case Op::atan2_:
            r = math::atan2(a, b);
            return a != 0 || b != 0;
        default:
            return false;
    }
}

bool fold_comparison(Op op, double a, double b, double& r) {
    switch (op) {
        case Op::lt_:
            r = a < b;
            return true;
        case Op::le_:
            r = a <= b;
            return true;
        case Op::gt_:
            r = a > b;
            return true;
        case Op::ge_:
            r = a >= b;
            return true;
        case Op::eq_:
            r = a == b;
            return true;
        case Op::ne_:
            r = a != b;
            return true;
        case Op::and_:
            r = a != 0 && b != 0;
            return true;
        case Op::or_:
            r = a != 0 || b != 0;
            return true;
        case Op::not_:
            r = a == 0;
            return true;
        default:
            return false;
    }
}

bool fold_conversion(Op op, const Constant& from, double& r) {
    const double a = from.lanes[0];
    if (op == Op::to_float_) {
        r = a;
        return true;
    }
    const double whole = std::trunc(a);
    if (op == Op::to_int_) {
        if (from.type == Type::uint_) {
            r = wrapped(Type::int_, static_cast<int64_t>(a));
            return true;
        }
        r = whole;
        return whole >= -2147483648.0 && whole <= 2147483647.0;
    }
    if (op != Op::to_uint_) return false;
    r = wrapped(Type::uint_, static_cast<int64_t>(a));
    return true;
}

bool fold_lane(Op op, Type type, Constants x, int lane, double& r) {
    double v[3] = {};
    for (size_t i = 0; i < x.size() && i < 3; ++i)
        v[i] = x[i].lanes[info(x[i].type).lanes > 1 ? static_cast<size_t>(lane) : 0];
    if (type == Type::int_ || type == Type::uint_) return fold_integer(op, type, v[0], v[1], r);
    return fold_arithmetic(op, v[0], v[1], v[2], r) || fold_transcendental(op, v[0], v[1], r);
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
    const OpInfo& row = info(op);
    if (row.rule == Rule::compare || row.rule == Rule::logic)
        return fold_comparison(op, operands[0].lanes[0],
                               operands.size() > 1 ? operands[1].lanes[0] : 0, lanes[0]);
    if (op == Op::column_) {
        for (size_t i = 0; i < 3; ++i)
            lanes[i] = operands[0].lanes[extra * 3 + i];
        return true;
    }
    if (op == Op::to_float_ || op == Op::to_int_ || op == Op::to_uint_)
        return fold_conversion(op, operands[0], lanes[0]);
    if (row.rule == Rule::special && op != Op::sign_nonzero_) {
        if (!fold_vector(op, operands, lanes)) return false;
    } else {
        for (int lane = 0; lane < info(result).lanes; ++lane)
            if (!fold_lane(op, result, operands, lane, lanes[static_cast<size_t>(lane)]))
                return false;
    }
    for (int lane = 0; lane < info(result).lanes; ++lane)
        if (!std::isfinite(lanes[static_cast<size_t>(lane)])) return false;
    return true;
}

}  // namespace wrinkle
