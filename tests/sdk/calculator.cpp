#include "sdk/calculator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wrinkle::testing {
namespace {

using Number = Calculator::Number;

double scalar(uint32_t op, double a, double b, double c) {
    switch (op) {
        case WR_OP_neg:
            return -a;
        case WR_OP_add:
            return a + b;
        case WR_OP_sub:
            return a - b;
        case WR_OP_mul:
            return a * b;
        case WR_OP_div:
            return a / b;
        case WR_OP_mod:
            return a - b * std::floor(a / b);
        case WR_OP_abs:
            return std::abs(a);
        case WR_OP_min:
            return b < a ? b : a;
        case WR_OP_max:
            return a < b ? b : a;
        case WR_OP_clamp:
            return std::min(std::max(a, b), c);
        case WR_OP_step:
            return b < a ? 0 : 1;
        case WR_OP_smoothstep: {
            if (!(a < b)) return NAN;
            const double t = std::clamp((c - a) / (b - a), 0.0, 1.0);
            return t * t * (3 - 2 * t);
        }
        case WR_OP_sqrt:
            return std::sqrt(a);
        case WR_OP_inversesqrt:
            return 1 / std::sqrt(a);
        case WR_OP_pow:
            return a < 0 || (a == 0 && b <= 0) ? NAN : std::pow(a, b);
        case WR_OP_log:
            return std::log(a);
        case WR_OP_log2:
            return std::log2(a);
        case WR_OP_asin:
            return std::asin(a);
        case WR_OP_acos:
            return std::acos(a);
        case WR_OP_atan2:
            return a == 0 && b == 0 ? NAN : std::atan2(a, b);
        case WR_OP_lt:
            return a < b;
        case WR_OP_gt:
            return a > b;
        case WR_OP_eq:
            return a == b;
        case WR_OP_ne:
            return a != b;
        case WR_OP_to_float:
            return a;
        case WR_OP_to_uint:
            return static_cast<double>(static_cast<uint32_t>(static_cast<int64_t>(a)));
    }
    throw std::invalid_argument("the calculator has no op " + std::to_string(op));
}

double bits(uint32_t op, uint32_t a, uint32_t b) {
    switch (op) {
        case WR_OP_add:
            return a + b;
        case WR_OP_mul:
            return a * b;
        case WR_OP_bit_xor:
            return a ^ b;
        case WR_OP_shift_right:
            return a >> b;
    }
    return scalar(op, a, b, 0);
}

double dot(const Number& a, const Number& b) {
    double sum = 0;
    for (uint32_t i = 0; i < a.lanes; ++i)
        sum += a.lane[i] * b.lane[i];
    return sum;
}

}  // namespace

Calculator::Calculator() {
    face.size = sizeof face;
    face.host = this;
    face.name = [](const wr_builder*, wr_value, const char*) {};
    face.literal = [](const wr_builder* b, uint32_t type, const double* lanes) {
        return self(b).add({{*lanes}, 1, type});
    };
    face.emit = [](const wr_builder* b, uint32_t op, uint32_t, const wr_value* args, uint32_t count,
                   uint32_t extra) { return self(b).emit(op, args, count, extra); };
}

wr_value Calculator::add(Number number) {
    values_.push_back(number);
    return static_cast<wr_value>(values_.size() - 1);
}

wr_value Calculator::emit(uint32_t op, const wr_value* args, uint32_t count, uint32_t extra) {
    std::array<Number, 4> in{};
    for (uint32_t i = 0; i < count; ++i)
        in[i] = values_.at(args[i]);
    const auto [a, b, c, d] = in;
    Number out{{}, std::max({a.lanes, b.lanes, c.lanes}), a.type};
    if (op == WR_OP_select) return add(a.lane[0] != 0 ? b : c);
    if (op == WR_OP_dot) return add({{dot(a, b)}});
    if (op == WR_OP_length) return add({{std::sqrt(dot(a, a))}});
    if (op == WR_OP_construct) {
        out.lanes = 0;
        for (uint32_t i = 0; i < count; ++i)
            for (uint32_t k = 0; k < in[i].lanes; ++k)
                out.lane[out.lanes++] = in[i].lane[k];
        return add(out);
    }
    if (op == WR_OP_swizzle) {
        out.lanes = extra & 15;
        for (uint32_t i = 0; i < out.lanes; ++i)
            out.lane[i] = a.lane[extra >> (4 + 4 * i) & 15];
        return add(out);
    }
    const auto lane = [](const Number& n, uint32_t i) { return n.lane[n.lanes == 1 ? 0 : i]; };
    for (uint32_t i = 0; i < out.lanes; ++i) {
        if (op == WR_OP_normalize)
            out.lane[i] = a.lane[i] / std::sqrt(dot(a, a));
        else if (a.type == WR_TYPE_uint)
            out.lane[i] =
                bits(op, static_cast<uint32_t>(a.lane[0]), static_cast<uint32_t>(b.lane[0]));
        else
            out.lane[i] = scalar(op, lane(a, i), lane(b, i), lane(c, i));
    }
    if (op == WR_OP_to_float) out.type = WR_TYPE_float;
    if (op == WR_OP_to_uint) out.type = WR_TYPE_uint;
    if (op >= WR_OP_lt && op <= WR_OP_not) out.type = WR_TYPE_bool;
    return add(out);
}

}  // namespace wrinkle::testing
