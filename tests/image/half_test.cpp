// Tests of half floats against the definition of the format with ldexp and a search for the nearest
// value.
#include "image/stored.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wrinkle {
namespace {

double defined_value(uint16_t bits) {
    const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
    const double sign = bits & 0x8000 ? -1 : 1;
    if (exponent == 31) return mantissa ? NAN : sign * INFINITY;
    if (exponent == 0) return sign * std::ldexp(mantissa, -24);
    return sign * std::ldexp(1024 + mantissa, exponent - 25);
}

TEST(Half, EveryValueIsTheDefinedOneAndComesBack) {
    for (uint32_t bits = 0; bits < 65536; ++bits) {
        const auto half = static_cast<uint16_t>(bits);
        const double expected = defined_value(half);
        const float value = float_from_half(half);
        if (std::isnan(expected)) {
            EXPECT_TRUE(std::isnan(value));
            EXPECT_TRUE(std::isnan(defined_value(half_from_float(value))));
            continue;
        }
        EXPECT_EQ(value, expected);
        EXPECT_EQ(std::signbit(value), std::signbit(expected));
        EXPECT_EQ(half_from_float(value), half);
    }
}

TEST(Half, RoundsToTheNearestAndTiesToEven) {
    for (uint16_t low = 0; low < 0x7BFF; ++low) {
        const auto high = static_cast<uint16_t>(low + 1);
        const auto middle = static_cast<float>((defined_value(low) + defined_value(high)) / 2);
        EXPECT_EQ(half_from_float(middle), low % 2 == 0 ? low : high);
        EXPECT_EQ(half_from_float(std::nextafter(middle, 0.0f)), low);
        EXPECT_EQ(half_from_float(std::nextafter(middle, 1e9f)), high);
    }
}

TEST(Half, BeyondTheLargestIsInfinite) {
    EXPECT_EQ(half_from_float(65519.996f), 0x7BFF);
    EXPECT_EQ(half_from_float(65520), 0x7C00);
    EXPECT_EQ(half_from_float(-std::numeric_limits<float>::max()), 0xFC00);
    EXPECT_EQ(half_from_float(std::numeric_limits<float>::denorm_min()), 0);
    EXPECT_EQ(half_from_float(-0.0f), 0x8000);
}

}  // namespace
}  // namespace wrinkle
