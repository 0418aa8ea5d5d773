// Transcendental functions with bit-identical results on every machine, compiler and instruction
// set.
//
// All arithmetic is in double: additions, multiplications, divisions and square roots, which IEEE
// 754 defines to the last bit, and bit operations; no libm, no fused multiply-add, no table, no
// branch, so loops over arrays vectorise. The float versions round the double result once: within 1
// ulp of the true value, and nearly always the nearest float. Those of sin and cos sum their series
// in float, for speed: within 1.5 ulp for |x| <= 1e6.
//
// Doubles have a relative error below 1e-15 (sin and cos: an absolute error, for |x| <= 1e6;
// beyond, it grows with |x|; pow: 1e-15 * (4 + |y log2 x|)). sin, cos and tan of |x| > 1e9 are NaN.
// Outside its domain a function returns NaN or an infinity as noted; no operation traps.
//
// Functions are always inlined, so a file compiled for another instruction set shares none of their
// code with the rest of the program.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace wrinkle::math {

#define WRINKLE_INLINE [[gnu::always_inline]] inline

namespace detail {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double ln2 = 0.693147180559945309417;
inline constexpr double log2e = 1.44269504088896340736;
inline constexpr double pi = 3.14159265358979323846;

// Adding this to a number below 2^51 rounds it to the nearest integer, which the low bits then
// hold.
inline constexpr double to_whole = 6755399441055744.0;  // 1.5 * 2^52

WRINKLE_INLINE uint64_t bits_of(double x) {
    return __builtin_bit_cast(uint64_t, x);
}
WRINKLE_INLINE double from_bits(uint64_t bits) {
    return __builtin_bit_cast(double, bits);
}

// Horner's rule; coefficients from the highest power down.
template <class T, class... Rest>
WRINKLE_INLINE T polynomial(T x, T highest, Rest... rest) {
    T sum = highest;
    ((sum = sum * x + rest), ...);
    return sum;
}

// Returns 2^k for an integer k in [-1022, 1023], given k + to_whole.
WRINKLE_INLINE double power_of_two(double shifted) {
    return from_bits((bits_of(shifted) + 1023) << 52);
}

// Returns e^r * 2^k for |r| <= ln2 / 2 and |k| <= 2000 with k = shifted - to_whole. e^r is a Taylor
// series with a truncation error below 2^-57. Two power-of-two factors reach subnormal results.
WRINKLE_INLINE double scaled_exp(double r, double shifted) {
    const double value = polynomial(r, 1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800,
                                    1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
                                    1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0);
    const double k = shifted - to_whole, half = k * 0.5 + to_whole;
    return value * power_of_two(half) * power_of_two(k - (half - to_whole) + to_whole);
}

WRINKLE_INLINE double within(double x, double limit) {
    const double low = x < -limit ? -limit : x;
    return low > limit ? limit : low;
}

// x = 2^exponent * m with m in [sqrt(1/2), sqrt(2)), for x > 0; log(m) = 2 artanh((m-1) / (m+1)).
struct Logarithm {
    double exponent;
    double of_mantissa;
};
WRINKLE_INLINE Logarithm logarithm(double x) {
    constexpr uint64_t sqrt_half = 0x3FE6A09E667F3BCD, one = 0x3FF0000000000000;
    constexpr uint64_t fraction = 0x000FFFFFFFFFFFFF, two_to_52 = 0x4330000000000000;
    const bool subnormal = x < 2.2250738585072014e-308;
    const uint64_t bits = bits_of(subnormal ? x * 18014398509481984.0 : x) + (one - sqrt_half);
    const double biased = from_bits(bits >> 52 | two_to_52) - 4503599627370496.0;
    const double m = from_bits((bits & fraction) + sqrt_half);
    const double s = (m - 1) / (m + 1);
    const double series = polynomial(s * s, 1.0 / 23, 1.0 / 21, 1.0 / 19, 1.0 / 17, 1.0 / 15,
                                     1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0);
    return {biased - (subnormal ? 1077.0 : 1023.0), 2 * s * series};
}
// Returns `value` for finite x > 0; -infinity at 0, NaN below 0 and for NaN, infinity at infinity.
WRINKLE_INLINE double logarithm_at(double x, double value) {
    const double below = x == 0 ? -infinity : nan;
    return x > 0 ? (x < infinity ? value : x) : below;
}

// pi/2 in three parts of 33, 33 and 53 bits: products of the first two with k up to 2^20 are exact.
inline constexpr double half_pi[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};

// sin and cos by Taylor series on [-pi/4, pi/4], with the first omitted terms below 2^-60.
struct SineCosine {
    double sine, cosine;
    uint64_t quadrant;
};
WRINKLE_INLINE SineCosine sine_cosine(double x) {
    const double usable = std::fabs(x) <= 1e9 ? x : nan;
    const double shifted = usable * (2 / pi) + to_whole, k = shifted - to_whole;
    const double first = usable - k * half_pi[0], second = k * half_pi[1], high = first - second;
    const double r = high + ((first - high) - second - k * half_pi[2]), q = r * r;
    const double sine = polynomial(q, 1.0 / 355687428096000, -1.0 / 1307674368000, 1.0 / 6227020800,
                                   -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6);
    const double cosine = polynomial(q, 1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600,
                                     -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24, -0.5);
    return {r + r * q * sine, 1 + q * cosine, bits_of(shifted)};
}
WRINKLE_INLINE double sine_of(const SineCosine& v, uint64_t quadrant) {
    const uint64_t odd = 0 - (quadrant & 1), sign = (quadrant & 2) << 62;
    return from_bits(((bits_of(v.cosine) & odd) | (bits_of(v.sine) & ~odd)) ^ sign);
}

// The same in float, but for the reduction of the angle; first omitted terms below 2^-28.
struct FloatSineCosine {
    float sine, cosine;
    uint32_t quadrant;
};
WRINKLE_INLINE FloatSineCosine sine_cosine(float x) {
    const double usable = std::fabs(x) <= 1e9F ? static_cast<double>(x) : nan;
    const double shifted = usable * (2 / pi) + to_whole, k = shifted - to_whole;
    const auto r = static_cast<float>(usable - k * half_pi[0] - k * half_pi[1]);
    const float q = r * r;
    const float sine = polynomial(q, 1.0F / 362880, -1.0F / 5040, 1.0F / 120, -1.0F / 6);
    const float cosine =
        polynomial(q, -1.0F / 3628800, 1.0F / 40320, -1.0F / 720, 1.0F / 24, -0.5F);
    return {r + r * q * sine, 1 + q * cosine, static_cast<uint32_t>(bits_of(shifted))};
}
WRINKLE_INLINE float sine_of(const FloatSineCosine& v, uint32_t quadrant) {
    const float size = quadrant & 1 ? v.cosine : v.sine;
    return quadrant & 2 ? -size : size;
}

// Returns the angle of (big, small), 0 <= small <= big: reduced to |t| <= tan(pi/12), then by
// series.
WRINKLE_INLINE double angle_below_diagonal(double small, double big) {
    constexpr double sqrt3 = 1.73205080756887729353, tan_twelfth = 0.26794919243112270647;
    const double x = big == 0 ? 0 : big == small ? 1 : small / big;
    const bool far = x > tan_twelfth;
    const double t = far ? (x * sqrt3 - 1) / (sqrt3 + x) : x;
    const double series =
        polynomial(t * t, 1.0 / 29, -1.0 / 27, 1.0 / 25, -1.0 / 23, 1.0 / 21, -1.0 / 19, 1.0 / 17,
                   -1.0 / 15, 1.0 / 13, -1.0 / 11, 1.0 / 9, -1.0 / 7, 1.0 / 5, -1.0 / 3);
    const double angle = t + t * (t * t) * series;
    return far ? angle + pi / 6 : angle;
}

}  // namespace detail

// Same bits as in <cmath>, but vectorised on machines without an instruction for it.
#if defined(__SSE4_1__)
WRINKLE_INLINE double floor(double x) {
    return __builtin_floor(x);
}
WRINKLE_INLINE float floor(float x) {
    return __builtin_floorf(x);
}
#else
WRINKLE_INLINE double floor(double x) {
    constexpr double all_whole = 4503599627370496.0;  // 2^52
    const double size = std::fabs(x);
    const double near = std::copysign((size + all_whole) - all_whole, x);
    return size < all_whole ? (near > x ? near - 1 : near) : x;
}
WRINKLE_INLINE float floor(float x) {
    constexpr float all_whole = 8388608.0F;  // 2^23
    const float size = std::fabs(x);
    const float near = std::copysign((size + all_whole) - all_whole, x);
    return size < all_whole ? (near > x ? near - 1 : near) : x;
}
#endif

WRINKLE_INLINE double exp2(double x) {
    using namespace detail;
    const double bounded = within(x, 1100), shifted = bounded + to_whole;
    return scaled_exp((bounded - (shifted - to_whole)) * ln2, shifted);
}
WRINKLE_INLINE double exp(double x) {
    using namespace detail;
    constexpr double high = 0x1.62e42fefa2p-1, low = 0x1.9ef35793c7673p-41;  // ln2
    const double bounded = within(x, 760), shifted = bounded * log2e + to_whole;
    const double k = shifted - to_whole;
    return scaled_exp((bounded - k * high) - k * low, shifted);
}

WRINKLE_INLINE double log(double x) {
    const detail::Logarithm v = detail::logarithm(x);
    return detail::logarithm_at(x, v.exponent * detail::ln2 + v.of_mantissa);
}
WRINKLE_INLINE double log2(double x) {
    const detail::Logarithm v = detail::logarithm(x);
    return detail::logarithm_at(x, v.exponent + v.of_mantissa * detail::log2e);
}
// Returns 0 at x = 0 for y > 0; NaN for x < 0.
WRINKLE_INLINE double pow(double x, double y) {
    return exp2(y * log2(x));
}

template <class T>
WRINKLE_INLINE T sin(T x) {
    const auto v = detail::sine_cosine(x);
    return detail::sine_of(v, v.quadrant);
}
template <class T>
WRINKLE_INLINE T cos(T x) {
    const auto v = detail::sine_cosine(x);
    return detail::sine_of(v, v.quadrant + 1);
}
WRINKLE_INLINE double tan(double x) {
    const detail::SineCosine v = detail::sine_cosine(x);
    return detail::sine_of(v, v.quadrant) / detail::sine_of(v, v.quadrant + 1);
}

// Returns an angle in [-pi, pi]; 0 at (0, 0).
WRINKLE_INLINE double atan2(double y, double x) {
    using detail::pi;
    const double ay = std::fabs(y), ax = std::fabs(x);
    const bool steep = ay > ax;
    const double part = detail::angle_below_diagonal(steep ? ax : ay, steep ? ay : ax);
    const double upper = steep ? pi / 2 - part : part;
    const double angle = x < 0 ? pi - upper : upper;
    return y < 0 ? -angle : angle;
}
WRINKLE_INLINE double atan(double x) {
    return atan2(x, 1);
}
// Returns NaN outside [-1, 1].
WRINKLE_INLINE double asin(double x) {
    return atan2(x, std::sqrt((1 - x) * (1 + x)));
}
WRINKLE_INLINE double acos(double x) {
    return atan2(std::sqrt((1 - x) * (1 + x)), x);
}

#define WRINKLE_ROUNDED(name)                                    \
    WRINKLE_INLINE float name(float x) {                         \
        return static_cast<float>(name(static_cast<double>(x))); \
    }
WRINKLE_ROUNDED(exp2)
WRINKLE_ROUNDED(exp)
WRINKLE_ROUNDED(log)
WRINKLE_ROUNDED(log2)
WRINKLE_ROUNDED(tan)
WRINKLE_ROUNDED(atan)
WRINKLE_ROUNDED(asin)
WRINKLE_ROUNDED(acos)
#undef WRINKLE_ROUNDED
WRINKLE_INLINE float pow(float x, float y) {
    return static_cast<float>(pow(static_cast<double>(x), static_cast<double>(y)));
}
WRINKLE_INLINE float atan2(float y, float x) {
    return static_cast<float>(atan2(static_cast<double>(y), static_cast<double>(x)));
}

#undef WRINKLE_INLINE

}  // namespace wrinkle::math
