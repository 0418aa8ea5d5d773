// Transcendental functions of our own: the same bits on every machine, compiler and instruction
// set.
//
// Everything is computed in double from additions, multiplications, divisions and square roots,
// which IEEE 754 defines to the last bit; nothing of libm, no fused multiply-add, no table. The
// float versions round the double result once, so they are correct to 0.5000001 ulp. Double results
// have a relative error below 1e-14 (sin, cos, tan: an absolute one below 1e-14, for |x| <= 1e6;
// pow: 1e-12). Arguments outside a function's domain give NaN or an infinity as noted, and never
// trap.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace wrinkle::math {

namespace detail {

inline constexpr double ln2 = 0.693147180559945309417;
inline constexpr double log2e = 1.44269504088896340736;
inline constexpr double pi = 3.14159265358979323846;

// 2^k for a whole k within [-1022, 1023].
inline double power_of_two(int64_t k) {
    return std::bit_cast<double>(static_cast<uint64_t>(k + 1023) << 52);
}

// e^x on |x| <= ln2 / 2 by its Taylor series; the next term is below 2^-55.
inline double small_exp(double x) {
    double sum = 1.0 / 87178291200.0;
    constexpr double inverse_factorials[] = {1.0 / 6227020800.0,
                                             1.0 / 479001600.0,
                                             1.0 / 39916800.0,
                                             1.0 / 3628800.0,
                                             1.0 / 362880.0,
                                             1.0 / 40320.0,
                                             1.0 / 5040.0,
                                             1.0 / 720.0,
                                             1.0 / 120.0,
                                             1.0 / 24.0,
                                             1.0 / 6.0,
                                             0.5,
                                             1.0,
                                             1.0};
    for (const double c : inverse_factorials)
        sum = sum * x + c;
    return sum;
}

// log(m) of m in [sqrt(1/2), sqrt(2)]: 2 artanh((m - 1) / (m + 1)).
inline double small_log(double m) {
    const double s = (m - 1) / (m + 1), q = s * s;
    double sum = 1.0 / 23;
    for (int k = 21; k >= 1; k -= 2)
        sum = sum * q + 1.0 / k;
    return 2 * s * sum;
}

struct Split {
    double mantissa;  // in [sqrt(1/2), sqrt(2))
    double exponent;
};
inline Split split(double x) {
    const bool subnormal = x < 2.2250738585072014e-308;
    const double scaled = subnormal ? x * 18014398509481984.0 : x;  // 2^54
    uint64_t bits = std::bit_cast<uint64_t>(scaled);
    auto exponent = static_cast<int64_t>(bits >> 52) - 1023 - (subnormal ? 54 : 0);
    double mantissa = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFu) | 0x3FF0000000000000u);
    const bool high = mantissa > 1.4142135623730951;
    mantissa = high ? mantissa * 0.5 : mantissa;
    exponent += high ? 1 : 0;
    return {mantissa, static_cast<double>(exponent)};
}

// x = k pi/2 + r, |r| <= pi/4; pi/2 in three parts of 33 bits (Cody and Waite).
struct Reduced {
    double r;
    int64_t quadrant;
};
inline Reduced reduce(double x) {
    constexpr double part1 = 1.57079632673412561417e+00, part2 = 6.07710050630396597660e-11,
                     part3 = 2.02226624871116645580e-21, rest = 8.47842766036889956997e-32;
    const bool usable = std::fabs(x) <= 1e9;  // false for NaN too
    const double safe = usable ? x : 0;
    const double k = std::floor(safe * (2 / pi) + 0.5);
    const double r = ((safe - k * part1) - k * part2) - k * part3 - k * rest;
    return {usable ? r : std::numeric_limits<double>::quiet_NaN(), static_cast<int64_t>(k) & 3};
}
inline double small_sin(double x) {
    const double q = x * x;
    double sum = 1.0 / 355687428096000.0;  // 17!
    constexpr double terms[] = {
        -1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0, 1.0 / 362880.0,
        -1.0 / 5040.0,          1.0 / 120.0,        -1.0 / 6.0};
    for (const double c : terms)
        sum = sum * q + c;
    return x + x * q * sum;
}
inline double small_cos(double x) {
    const double q = x * x;
    double sum = 1.0 / 20922789888000.0;  // 16!
    constexpr double terms[] = {-1.0 / 87178291200.0,
                                1.0 / 479001600.0,
                                -1.0 / 3628800.0,
                                1.0 / 40320.0,
                                -1.0 / 720.0,
                                1.0 / 24.0,
                                -0.5,
                                1.0};
    for (const double c : terms)
        sum = sum * q + c;
    return sum;
}

// atan of x in [0, 1]: brought to |t| <= tan(pi/12), then its series.
inline double small_atan(double x) {
    constexpr double sqrt3 = 1.73205080756887729353, tan_twelfth = 0.26794919243112270647;
    const bool far = x > tan_twelfth;
    const double t = far ? (x * sqrt3 - 1) / (sqrt3 + x) : x;
    const double q = t * t;
    double sum = 1.0 / 29;
    double sign = -1;
    for (int k = 27; k >= 1; k -= 2, sign = -sign)
        sum = sum * q + sign / k;
    return t * sum + (far ? pi / 6 : 0);
}

}  // namespace detail

inline double exp2(double x) {
    using namespace detail;
    const double low = x < -1080 ? -1080 : x;
    const double bounded = low > 1030 ? 1030 : low;
    const double whole = std::floor((bounded == bounded ? bounded : 0) + 0.5);
    const auto k = static_cast<int64_t>(whole);
    const int64_t half = k / 2;
    return small_exp((bounded - whole) * ln2) * power_of_two(half) * power_of_two(k - half);
}
inline double exp(double x) {
    return exp2(x * detail::log2e);
}

// -infinity at 0, NaN below.
inline double log(double x) {
    using namespace detail;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool inside = x > 0 && x < infinity;
    const Split parts = split(inside ? x : 1);
    const double value = parts.exponent * ln2 + small_log(parts.mantissa);
    const double outside = x == 0  ? -infinity
                           : x > 0 ? x
                                   : std::numeric_limits<double>::quiet_NaN();
    return inside ? value : outside;
}
inline double log2(double x) {
    using namespace detail;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool inside = x > 0 && x < infinity;
    const Split parts = split(inside ? x : 1);
    const double value = parts.exponent + small_log(parts.mantissa) * log2e;
    const double outside = x == 0  ? -infinity
                           : x > 0 ? x
                                   : std::numeric_limits<double>::quiet_NaN();
    return inside ? value : outside;
}
// 0 at x = 0; NaN below.
inline double pow(double x, double y) {
    return exp2(y * log2(x));
}

// NaN beyond |x| = 1e9.
inline double sin(double x) {
    const detail::Reduced v = detail::reduce(x);
    const double value = v.quadrant & 1 ? detail::small_cos(v.r) : detail::small_sin(v.r);
    return v.quadrant & 2 ? -value : value;
}
inline double cos(double x) {
    const detail::Reduced v = detail::reduce(x);
    const double value = v.quadrant & 1 ? detail::small_sin(v.r) : detail::small_cos(v.r);
    return (v.quadrant + 1) & 2 ? -value : value;
}
inline double tan(double x) {
    return sin(x) / cos(x);
}

// In [-pi, pi]; 0 at (0, 0).
inline double atan2(double y, double x) {
    using namespace detail;
    const double ay = std::fabs(y), ax = std::fabs(x);
    const bool steep = ay > ax;
    const double big = steep ? ay : ax, small = steep ? ax : ay;
    double angle = small_atan(big == 0 ? 0 : big == small ? 1 : small / big);
    angle = steep ? pi / 2 - angle : angle;
    angle = x < 0 ? pi - angle : angle;
    return y < 0 ? -angle : angle;
}
inline double atan(double x) {
    return atan2(x, 1);
}
// NaN outside [-1, 1].
inline double asin(double x) {
    return atan2(x, std::sqrt((1 - x) * (1 + x)));
}
inline double acos(double x) {
    return atan2(std::sqrt((1 - x) * (1 + x)), x);
}

#define WRINKLE_ROUNDED(name)                                    \
    inline float name(float x) {                                 \
        return static_cast<float>(name(static_cast<double>(x))); \
    }
WRINKLE_ROUNDED(exp2)
WRINKLE_ROUNDED(exp)
WRINKLE_ROUNDED(log)
WRINKLE_ROUNDED(log2)
WRINKLE_ROUNDED(sin)
WRINKLE_ROUNDED(cos)
WRINKLE_ROUNDED(tan)
WRINKLE_ROUNDED(atan)
WRINKLE_ROUNDED(asin)
WRINKLE_ROUNDED(acos)
#undef WRINKLE_ROUNDED
inline float pow(float x, float y) {
    return static_cast<float>(pow(static_cast<double>(x), static_cast<double>(y)));
}
inline float atan2(float y, float x) {
    return static_cast<float>(atan2(static_cast<double>(y), static_cast<double>(x)));
}

}  // namespace wrinkle::math
