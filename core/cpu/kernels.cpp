#include "cpu/kernels.h"

#include <limits>

namespace wrinkle {
namespace {

template <class T, class F>
bool each(T* out, const T* a, size_t n, F f) {
    for (size_t k = 0; k < n; ++k)
        out[k] = f(a[k]);
    return true;
}
template <class T, class F>
bool each(T* out, const T* a, const T* b, size_t n, F f) {
    for (size_t k = 0; k < n; ++k)
        out[k] = f(a[k], b[k]);
    return true;
}
template <class T, class F>
bool each(T* out, const T* a, const T* b, const T* c, size_t n, F f) {
    for (size_t k = 0; k < n; ++k)
        out[k] = f(a[k], b[k], c[k]);
    return true;
}

template <class T>
T smoothstep(T low, T high, T x) {
    const T raw = (x - low) / (high - low);
    const T positive = raw < 0 ? T(0) : raw;
    const T t = T(1) < positive ? T(1) : positive;
    return t * t * (3 - 2 * t);
}

int32_t as_signed(uint32_t x) {
    return static_cast<int32_t>(x);
}

template <class T>
uint32_t truncated(T x) {
    constexpr T low = T(-2147483648.0), high = T(2147483648.0);
    const bool fits = x >= low && x < high;
    return fits ? static_cast<uint32_t>(static_cast<int32_t>(x)) : 0;
}

template <class A>
bool compare(Op op, uint32_t* out, const A* a, const A* b, size_t n) {
    switch (op) {
        case Op::lt_:
            for (size_t k = 0; k < n; ++k)
                out[k] = a[k] < b[k];
            return true;
        case Op::le_:
            for (size_t k = 0; k < n; ++k)
                out[k] = a[k] <= b[k];
            return true;
        case Op::gt_:
            for (size_t k = 0; k < n; ++k)
                out[k] = a[k] > b[k];
            return true;
        case Op::ge_:
            for (size_t k = 0; k < n; ++k)
                out[k] = a[k] >= b[k];
            return true;
        case Op::eq_:
            for (size_t k = 0; k < n; ++k)
                out[k] = a[k] == b[k];
            return true;
        case Op::ne_:
            for (size_t k = 0; k < n; ++k)
                out[k] = a[k] != b[k];
            return true;
        default:
            return false;
    }
}

}  // namespace

template <class T>
bool run_arithmetic(const Step& step, Registers<T>& r, size_t n) {
    T* out = r.f(step.out[0]);
    const T *a = r.f(step.in[0]), *b = r.f(step.in[1]), *c = r.f(step.in[2]);
    switch (step.op) {
        case Op::neg_:
            return each(out, a, n, [](T x) { return -x; });
        case Op::add_:
            return each(out, a, b, n, [](T x, T y) { return x + y; });
        case Op::sub_:
            return each(out, a, b, n, [](T x, T y) { return x - y; });
        case Op::mul_:
            return each(out, a, b, n, [](T x, T y) { return x * y; });
        case Op::div_:
            return each(out, a, b, n, [](T x, T y) { return x / y; });
        case Op::mod_:
            return each(out, a, b, n, [](T x, T y) { return x - y * std::floor(x / y); });
        case Op::abs_:
            return each(out, a, n, [](T x) { return std::fabs(x); });
        case Op::sign_:
            return each(out, a, n, [](T x) { return x > 0 ? T(1) : x < 0 ? T(-1) : T(0); });
        case Op::sign_nonzero_:
            return each(out, a, n, [](T x) { return x < 0 ? T(-1) : T(1); });
        case Op::floor_:
            return each(out, a, n, [](T x) { return std::floor(x); });
        case Op::ceil_:
            return each(out, a, n, [](T x) { return std::ceil(x); });
        case Op::fract_:
            return each(out, a, n, [](T x) { return x - std::floor(x); });
        case Op::min_:
            return each(out, a, b, n, [](T x, T y) { return y < x ? y : x; });
        case Op::max_:
            return each(out, a, b, n, [](T x, T y) { return x < y ? y : x; });
        case Op::clamp_:
            return each(out, a, b, c, n, [](T x, T low, T high) {
                const T above = x < low ? low : x;
                return high < above ? high : above;
            });
        case Op::mix_:
            return each(out, a, b, c, n, [](T x, T y, T t) { return x * (1 - t) + y * t; });
        case Op::step_:
            return each(out, a, b, n, [](T e, T x) { return x < e ? T(0) : T(1); });
        case Op::smoothstep_:
            return each(out, a, b, c, n, smoothstep<T>);
        case Op::sqrt_:
            return each(out, a, n, [](T x) { return std::sqrt(x); });
        case Op::inversesqrt_:
            return each(out, a, n, [](T x) { return 1 / std::sqrt(x); });
        case Op::select_: {
            const uint32_t* condition = r.i(step.in[0]);
            for (size_t k = 0; k < n; ++k)
                out[k] = condition[k] ? b[k] : c[k];
            return true;
        }
        default:
            return false;
    }
}

template <class T>
bool run_transcendental(const Step& step, Registers<T>& r, size_t n) {
    T* out = r.f(step.out[0]);
    const T *a = r.f(step.in[0]), *b = r.f(step.in[1]);
    switch (step.op) {
        case Op::pow_:
            return each(out, a, b, n, [](T x, T y) { return math::pow(x, y); });
        case Op::exp_:
            return each(out, a, n, [](T x) { return math::exp(x); });
        case Op::log_:
            return each(out, a, n, [](T x) { return math::log(x); });
        case Op::exp2_:
            return each(out, a, n, [](T x) { return math::exp2(x); });
        case Op::log2_:
            return each(out, a, n, [](T x) { return math::log2(x); });
        case Op::sin_:
            return each(out, a, n, [](T x) { return math::sin(x); });
        case Op::cos_:
            return each(out, a, n, [](T x) { return math::cos(x); });
        case Op::tan_:
            return each(out, a, n, [](T x) { return math::tan(x); });
        case Op::asin_:
            return each(out, a, n, [](T x) { return math::asin(x); });
        case Op::acos_:
            return each(out, a, n, [](T x) { return math::acos(x); });
        case Op::atan_:
            return each(out, a, n, [](T x) { return math::atan(x); });
        case Op::atan2_:
            return each(out, a, b, n, [](T y, T x) { return math::atan2(y, x); });
        default:
            return false;
    }
}

template <class T>
bool run_comparison(const Step& step, Registers<T>& r, size_t n) {
    uint32_t* out = r.i(step.out[0]);
    if (step.type == Type::float_)
        return compare(step.op, out, r.f(step.in[0]), r.f(step.in[1]), n);
    const uint32_t *a = r.i(step.in[0]), *b = r.i(step.in[1]);
    if (step.type != Type::int_) return compare(step.op, out, a, b, n);
    // Flipping the top bit orders two's complement as unsigned.
    std::vector<uint32_t> x(a, a + n), y(b, b + n);
    for (size_t k = 0; k < n; ++k) {
        x[k] ^= 0x80000000u;
        y[k] ^= 0x80000000u;
    }
    return compare(step.op, out, x.data(), y.data(), n);
}

bool run_integer(const Step& step, uint32_t* out, const uint32_t* a, const uint32_t* b, size_t n) {
    const bool is_signed = step.type == Type::int_;
    const auto less = [is_signed](uint32_t x, uint32_t y) {
        return is_signed ? as_signed(x) < as_signed(y) : x < y;
    };
    switch (step.op) {
        case Op::neg_:
            return each(out, a, n, [](uint32_t x) { return 0u - x; });
        case Op::add_:
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x + y; });
        case Op::sub_:
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x - y; });
        case Op::mul_:
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x * y; });
        case Op::min_:
            return each(out, a, b, n, [&](uint32_t x, uint32_t y) { return less(y, x) ? y : x; });
        case Op::max_:
            return each(out, a, b, n, [&](uint32_t x, uint32_t y) { return less(x, y) ? y : x; });
        case Op::and_:
        case Op::bit_and_:
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x & y; });
        case Op::or_:
        case Op::bit_or_:
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x | y; });
        case Op::bit_xor_:
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x ^ y; });
        case Op::not_:
            return each(out, a, n, [](uint32_t x) { return x ^ 1u; });
        case Op::shift_left_:
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x << (y & 31); });
        case Op::shift_right_:
            if (is_signed)
                return each(out, a, b, n, [](uint32_t x, uint32_t y) {
                    return static_cast<uint32_t>(as_signed(x) >> (y & 31));
                });
            return each(out, a, b, n, [](uint32_t x, uint32_t y) { return x >> (y & 31); });
        case Op::to_int_:
        case Op::to_uint_:
            return each(out, a, n, [](uint32_t x) { return x; });
        default:
            return false;
    }
}

template <class T>
bool run_conversion(const Step& step, Registers<T>& r, size_t n) {
    if (step.op == Op::to_int_ && step.type == Type::float_) {
        const T* a = r.f(step.in[0]);
        uint32_t* out = r.i(step.out[0]);
        for (size_t k = 0; k < n; ++k)
            out[k] = truncated(a[k]);
        return true;
    }
    if (step.op != Op::to_float_) return false;
    T* out = r.f(step.out[0]);
    if (step.type == Type::float_)
        return each(out, static_cast<const T*>(r.f(step.in[0])), n, [](T x) { return x; });
    const uint32_t* a = r.i(step.in[0]);
    const bool is_signed = step.type == Type::int_;
    for (size_t k = 0; k < n; ++k)
        out[k] = is_signed ? static_cast<T>(as_signed(a[k])) : static_cast<T>(a[k]);
    return true;
}

#define WRINKLE_INSTANTIATE(T)                                               \
    template bool run_arithmetic<T>(const Step&, Registers<T>&, size_t);     \
    template bool run_transcendental<T>(const Step&, Registers<T>&, size_t); \
    template bool run_comparison<T>(const Step&, Registers<T>&, size_t);     \
    template bool run_conversion<T>(const Step&, Registers<T>&, size_t);
WRINKLE_INSTANTIATE(float)
WRINKLE_INSTANTIATE(double)
#undef WRINKLE_INSTANTIATE

}  // namespace wrinkle
