// Tests of the transcendental functions against the C library in long double, over their domains.
#include "base/transcendental.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace wrinkle {
namespace {

using Wide = long double;

struct Function {
    std::string name;
    double (*ours)(double);
    float (*ours_float)(float);
    Wide (*theirs)(Wide);
    double low, high;               // arguments, evenly spaced
    double relative;                // bound documented in the header, for double
    double absolute = 0;            // the same, for results near 0
    bool spread_exponents = false;  // arguments evenly spaced over powers of two instead
};

const Function functions[] = {
    {"sin", math::sin, math::sin, [](Wide x) { return sinl(x); }, -1e6, 1e6, 0, 1e-15},
    {"sin small", math::sin, math::sin, [](Wide x) { return sinl(x); }, -3, 3, 1e-15, 1e-15},
    {"cos", math::cos, math::cos, [](Wide x) { return cosl(x); }, -1e6, 1e6, 0, 1e-15},
    {"cos small", math::cos, math::cos, [](Wide x) { return cosl(x); }, -3, 3, 1e-15, 1e-15},
    {"tan", math::tan, math::tan, [](Wide x) { return tanl(x); }, -1.5, 1.5, 1e-15, 0},
    {"asin", math::asin, math::asin, [](Wide x) { return asinl(x); }, -1, 1, 1e-15, 0},
    {"acos", math::acos, math::acos, [](Wide x) { return acosl(x); }, -1, 1, 1e-15, 0},
    {"atan", math::atan, math::atan, [](Wide x) { return atanl(x); }, -20, 20, 1e-15, 0},
    {"atan far", math::atan, math::atan, [](Wide x) { return atanl(x); }, -300, 300, 1e-15, 0,
     true},
    {"exp", math::exp, math::exp, [](Wide x) { return expl(x); }, -87, 88, 1e-15, 0},
    {"exp wide", math::exp, math::exp, [](Wide x) { return expl(x); }, -700, 700, 1e-15, 0},
    {"exp2", math::exp2, math::exp2, [](Wide x) { return exp2l(x); }, -126, 127, 1e-15, 0},
    {"exp2 wide", math::exp2, math::exp2, [](Wide x) { return exp2l(x); }, -1021, 1023, 1e-15, 0},
    {"log", math::log, math::log, [](Wide x) { return logl(x); }, 0.3, 3, 1e-15, 0},
    {"log far", math::log, math::log, [](Wide x) { return logl(x); }, -1074, 1023, 1e-15, 0, true},
    {"log2", math::log2, math::log2, [](Wide x) { return log2l(x); }, 0.3, 3, 1e-15, 0},
    {"log2 far", math::log2, math::log2, [](Wide x) { return log2l(x); }, -1074, 1023, 1e-15, 0,
     true},
};

double argument(const Function& f, std::mt19937_64& random) {
    const double t = std::uniform_real_distribution<double>(f.low, f.high)(random);
    if (!f.spread_exponents) return t;
    const double sign = f.name.starts_with("log") || random() & 1 ? 1 : -1;
    return sign * std::exp2(t);
}

TEST(Transcendental, DoublesKeepTheirPromise) {
    for (const Function& f : functions) {
        std::mt19937_64 random(7);
        Wide worst = 0;
        double where = 0;
        for (int i = 0; i < 20000; ++i) {
            const double x = argument(f, random);
            const Wide expected = f.theirs(x);
            const Wide excess =
                std::fabs(f.ours(x) - expected) / (f.relative * std::fabs(expected) + f.absolute);
            if (!(excess <= worst)) worst = excess, where = x;
        }
        EXPECT_LE(worst, 1) << f.name << " at " << where;
    }
}

// Number of float steps between a and b.
int64_t floats_apart(float a, float b) {
    const auto order = [](float x) {
        const auto bits = std::bit_cast<int32_t>(x);
        return static_cast<int64_t>(bits < 0 ? INT32_MIN - static_cast<int64_t>(bits) : bits);
    };
    return std::abs(order(a) - order(b));
}

TEST(Transcendental, FloatsAreRoundedOnce) {
    for (const Function& f : functions) {
        // Series that are summed in float are within 1.5 ulp, so at most two floats off.
        const bool in_float = f.name.starts_with("sin") || f.name.starts_with("cos");
        std::mt19937_64 random(8);
        int differ = 0, tried = 0;
        for (int i = 0; i < 20000; ++i) {
            const auto x = static_cast<float>(argument(f, random));
            if (!std::isfinite(x) || (f.name.starts_with("log") && x <= 0)) continue;
            const auto expected = static_cast<float>(f.theirs(static_cast<Wide>(x)));
            const int64_t apart = floats_apart(f.ours_float(x), expected);
            ++tried;
            differ += apart != 0;
            ASSERT_LE(apart, in_float ? 2 : 1) << f.name << " at " << x;
        }
        // Ties between two floats are rare.
        if (!in_float) {
            EXPECT_LE(differ * 10000, tried + 10000) << f.name;
        }
    }
}

TEST(Transcendental, PowersOfPositiveNumbers) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> exponent(-30, 30), power(-8, 8);
    for (int i = 0; i < 20000; ++i) {
        const double x = std::exp2(exponent(random)), y = power(random);
        const Wide expected = powl(x, y);
        ASSERT_LE(std::fabs(math::pow(x, y) / expected - 1),
                  1e-15L * (4 + std::fabs(y * std::log2(x))))
            << x << " to the " << y;
        const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
        const auto rounded = static_cast<float>(powl(fx, fy));
        if (!std::isfinite(rounded)) continue;
        ASSERT_LE(floats_apart(math::pow(fx, fy), rounded), 1) << fx << " to the " << fy;
    }
    EXPECT_EQ(math::pow(2.0, 10.0), 1024);
    EXPECT_EQ(math::pow(0.0, 2.0), 0);
    EXPECT_EQ(math::pow(7.0, 0.0), 1);
}

TEST(Transcendental, AnglesOfPoints) {
    std::mt19937_64 random(10);
    std::uniform_real_distribution<double> side(-5, 5);
    for (int i = 0; i < 20000; ++i) {
        const double y = side(random), x = side(random);
        const Wide expected = atan2l(y, x);
        ASSERT_LE(std::fabs(math::atan2(y, x) - expected), 1e-15L * std::fabs(expected));
    }
    EXPECT_EQ(math::atan2(0.0, 1.0), 0);
    EXPECT_DOUBLE_EQ(math::atan2(0.0, -1.0), std::acos(-1.0));
    EXPECT_DOUBLE_EQ(math::atan2(1.0, 0.0), std::acos(0.0));
    EXPECT_DOUBLE_EQ(math::atan2(-1.0, 0.0), -std::acos(0.0));
    EXPECT_TRUE(std::isfinite(math::atan2(0.0, 0.0)));
    EXPECT_DOUBLE_EQ(math::atan2(1e-300, 1e300), 0);
}

// Recorded bits: gcc, clang and every -march must reproduce them.
TEST(Transcendental, EveryCompilerGivesTheseBits) {
    uint64_t state = 1, hash = 14695981039346656037u;
    const auto add = [&](double value) {
        if (value == value) hash = (hash ^ std::bit_cast<uint64_t>(value)) * 1099511628211u;
    };
    for (const Function& f : functions)
        for (int i = 0; i < 1000; ++i) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            const double t = static_cast<double>(state >> 11) / 9007199254740992.0;
            const double x = f.spread_exponents ? t * 1e5 : f.low + (f.high - f.low) * t;
            add(f.ours(x));
            add(static_cast<double>(f.ours_float(static_cast<float>(x))));
            add(math::pow(t + 0.5, x * 1e-6));
            add(math::atan2(t - 0.5, x));
        }
    EXPECT_EQ(hash, 11411843722796742685u);
}

TEST(Transcendental, FloorIsTheFloor) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 100000; ++i) {
        const auto x = std::bit_cast<double>(random());
        const auto f = std::bit_cast<float>(static_cast<uint32_t>(random()));
        if (!std::isnan(x)) {
            ASSERT_EQ(std::bit_cast<uint64_t>(math::floor(x)),
                      std::bit_cast<uint64_t>(std::floor(x)))
                << x;
        }
        if (!std::isnan(f)) {
            ASSERT_EQ(std::bit_cast<uint32_t>(math::floor(f)),
                      std::bit_cast<uint32_t>(std::floor(f)))
                << f;
        }
    }
    for (const double x : {0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 1.5, 2.5, -2.5, 8388607.5, 8388608.5,
                           4503599627370495.5, -4503599627370495.5}) {
        EXPECT_EQ(std::bit_cast<uint64_t>(math::floor(x)), std::bit_cast<uint64_t>(std::floor(x)));
        const auto f = static_cast<float>(x);
        EXPECT_EQ(std::bit_cast<uint32_t>(math::floor(f)), std::bit_cast<uint32_t>(std::floor(f)));
    }
    EXPECT_TRUE(std::isnan(math::floor(std::nan(""))));
}

TEST(Transcendental, Corners) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(math::exp(0.0), 1);
    EXPECT_EQ(math::exp(-infinity), 0);
    EXPECT_EQ(math::exp(infinity), infinity);
    EXPECT_EQ(math::exp(1e308), infinity);
    EXPECT_EQ(math::exp2(-1e308), 0);
    EXPECT_EQ(math::exp2(10.0), 1024);
    EXPECT_EQ(math::exp2(-1074.0), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(math::log2(1024.0), 10);
    EXPECT_EQ(math::log(1.0), 0);
    EXPECT_EQ(math::log(0.0), -infinity);
    EXPECT_EQ(math::log(infinity), infinity);
    EXPECT_TRUE(std::isnan(math::log(-1.0)));
    EXPECT_EQ(math::atan(infinity), std::acos(0.0));
    EXPECT_EQ(math::asin(1.0), std::acos(0.0));
    EXPECT_EQ(math::acos(1.0), 0);
    EXPECT_TRUE(std::isnan(math::asin(1.5)));
    for (const double bad : {infinity, -infinity, nan, 1e30})
        EXPECT_TRUE(std::isnan(math::sin(bad)) && std::isnan(math::cos(bad)));
    for (const Function& f : functions)
        EXPECT_TRUE(std::isnan(f.ours(nan))) << f.name;
}

}  // namespace
}  // namespace wrinkle
