// Tests of the guarded functions: correct inside their domain, finite everywhere else.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sdk/calculator.h"
#include "wrinkle/node.h"

namespace wrinkle::testing {
namespace {

using namespace sdk;

class Math : public ::testing::Test {
protected:
    template <class T>
    double number(T value, size_t lane = 0) {
        return calculator[value.id].lane[lane];
    }
    Calculator calculator;
    UseBuilder use{&calculator.face};
};

const double corners[] = {-1e30, -128, -2, -1, -0.5, -1e-30, -0.0, 0, 1e-30, 0.5, 1, 2, 128, 1e30};

TEST_F(Math, FunctionsOfOneNumberAreFiniteEverywhere) {
    for (const double x : corners) {
        const Float v = x;
        for (const Float y : {sqrt(v), inversesqrt(v), log(v), log2(v), asin(v), acos(v)})
            EXPECT_TRUE(std::isfinite(number(y))) << x;
    }
}

TEST_F(Math, FunctionsOfTwoNumbersAreFiniteEverywhere) {
    for (const double x : {-2.0, -0.0, 0.0, 0.5, 3.0})
        for (const double y : {-2.0, -1.0, 0.0, 0.5, 2.0}) {
            const Float a = x, b = y;
            for (const Float z : {pow(a, b), pow(a, y), divide(a, b), mod(a, b), mod(a, y),
                                  atan(a, b), smoothstep(a, b, Float(1)), smoothstep(x, x, b)})
                EXPECT_TRUE(std::isfinite(number(z))) << x << " " << y;
            EXPECT_DOUBLE_EQ(number(pow(a, b)), number(pow(a, y))) << x << " " << y;
        }
}

TEST_F(Math, GuardsChangeNothingInside) {
    EXPECT_DOUBLE_EQ(number(sqrt(Float(9))), 3);
    EXPECT_DOUBLE_EQ(number(inversesqrt(Float(4))), 0.5);
    EXPECT_DOUBLE_EQ(number(pow(Float(2), Float(10))), 1024);
    EXPECT_DOUBLE_EQ(number(pow(Float(2), -1.0)), 0.5);
    EXPECT_DOUBLE_EQ(number(divide(1.0, Float(-4))), -0.25);
    EXPECT_DOUBLE_EQ(number(mod(Float(-1), 3.0)), 2);
    EXPECT_DOUBLE_EQ(number(atan(Float(1), Float(-1))), 2.356194490192345);
    EXPECT_DOUBLE_EQ(number(acos(Float(0.5))), 1.0471975511965979);
}

TEST_F(Math, CornersAreAsDocumented) {
    EXPECT_EQ(number(sqrt(Float(-4))), 0);
    EXPECT_EQ(number(pow(Float(0), Float(0))), 1);
    EXPECT_EQ(number(pow(Float(0), Float(-1))), 0);
    EXPECT_EQ(number(pow(Float(-3), Float(2))), 0);
    EXPECT_EQ(number(divide(Float(5), Float(0))), 0);
    EXPECT_EQ(number(mod(Float(5), Float(0))), 0);
    EXPECT_EQ(number(asin(Float(2))), std::asin(1.0));
    EXPECT_EQ(number(atan(Float(0), Float(0))), 0);
}

TEST_F(Math, NormalizeOfAZeroVectorIsZero) {
    for (size_t lane = 0; lane < 3; ++lane)
        EXPECT_EQ(number(normalize(vec3(Float(0))), lane), 0);
    EXPECT_DOUBLE_EQ(number(normalize(vec2(3, 4)), 1), 0.8);
}

TEST_F(Math, SmoothstepGoesBothWaysAndIsAStepBetweenEqualEdges) {
    EXPECT_DOUBLE_EQ(number(smoothstep(Float(0), Float(2), Float(1))), 0.5);
    EXPECT_DOUBLE_EQ(number(smoothstep(Float(0), Float(4), Float(1))), 0.15625);
    EXPECT_DOUBLE_EQ(number(smoothstep(Float(4), Float(0), Float(1))), 1 - 0.15625);
    EXPECT_EQ(number(smoothstep(Float(1), Float(1), Float(0.9))), 0);
    EXPECT_EQ(number(smoothstep(Float(1), Float(1), Float(1.1))), 1);
}

TEST_F(Math, SwizzlesNameComponents) {
    const vec4 v(1, 2, 3, 4);
    EXPECT_EQ(number(v.zw()), 3);
    EXPECT_EQ(number(v.yzx(), 2), 1);
    EXPECT_EQ(number(v.a()), 4);
    EXPECT_EQ(number(v.swizzle<"wwzx">(), 1), 4);
    EXPECT_EQ(number(v.swizzle<"wwzx">(), 3), 1);
}

TEST_F(Math, OperatorsBroadcastFloats) {
    const vec3 v = 2 * vec3(1, 2, 3) - 1;
    EXPECT_EQ(number(v, 2), 5);
    vec2 w(8, 4);
    w /= vec2(4, 2);
    w *= 3;
    EXPECT_EQ(number(w, 0), 6);
    EXPECT_EQ(number(1 / w, 1), 1 / 6.0);
}

// hash() without its function, which the calculator cannot record.
Uint hashed(int x, int y, int z) {
    using detail::permuted;
    return permuted(Uint(Int(x)) + permuted(Uint(Int(y)) + permuted(Uint(Int(z)))));
}

TEST_F(Math, HashesSpreadAndTellAxesApart) {
    std::set<double> seen;
    double sum = 0;
    for (int x = -8; x < 8; ++x)
        for (int y = -8; y < 8; ++y)
            for (int z = -8; z < 8; ++z) {
                const Uint bits = hashed(x, y, z);
                seen.insert(number(bits));
                const double unit = number(unit_float(bits));
                EXPECT_GE(unit, 0);
                EXPECT_LT(unit, 1);
                sum += unit;
            }
    EXPECT_GE(seen.size(), 4090u);  // out of 4096
    EXPECT_NEAR(sum / 4096, 0.5, 0.02);
    EXPECT_NE(number(hashed(0, 1, 2)), number(hashed(0, 2, 1)));
}

TEST(Outside, OperationsWithoutABuilderArePoison) {
    EXPECT_EQ((vec3(1, 2, 3) * 2).id, WR_POISON);
    EXPECT_EQ(vec2(surface::uv0).id, WR_POISON);
}

}  // namespace
}  // namespace wrinkle::testing
