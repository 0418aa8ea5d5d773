// Tests of single nodes against the C library and elementary mathematics.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

struct Case {
    const char* type;
    const char* in;
    const char* output;
    std::vector<double> expected;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.type << " {" << c.in << "}";
}

class Numbers : public ::testing::TestWithParam<Case> {};

TEST_P(Numbers, AreRight) {
    const Case& c = GetParam();
    const auto got = value({one(c.type, c.in), std::string("n.") + c.output});
    ASSERT_EQ(got.size(), c.expected.size());
    for (size_t i = 0; i < got.size(); ++i)
        EXPECT_NEAR(got[i], c.expected[i], 1e-6);
}

// clang-format off
const Case arithmetic[] = {
    {"add", R"("a": 2, "b": 0.5)", "result", {2.5}},
    {"subtract", R"("a": 2, "b": 0.5)", "result", {1.5}},
    {"multiply", R"("a": 2, "b": -0.5)", "result", {-1}},
    {"divide", R"("a": 3, "b": -2)", "result", {-1.5}},
    {"divide", R"("a": 3, "b": 0)", "result", {0}},
    {"negate", R"("x": 3)", "result", {-3}},
    {"absolute", R"("x": -3)", "result", {3}},
    {"minimum", R"("a": 2, "b": -1)", "result", {-1}},
    {"maximum", R"("a": 2, "b": -1)", "result", {2}},
    {"clamp", R"("x": -2, "low": -1, "high": 1)", "result", {-1}},
    {"clamp", R"("x": 0, "low": 2, "high": 1)", "result", {1}},
    {"mix", R"("a": 2, "b": 6, "mask": 0.25)", "result", {3}},
    {"step", R"("edge": 1, "x": 1)", "result", {1}},
    {"step", R"("edge": 1, "x": 0.99)", "result", {0}},
    {"smoothstep", R"("low": 0, "high": 4, "x": 1)", "result", {0.15625}},
    {"smoothstep", R"("low": 4, "high": 0, "x": 1)", "result", {0.84375}},
    {"smoothstep", R"("low": 2, "high": 2, "x": 3)", "result", {1}},
    {"remap", R"("x": 5, "from_low": 0, "from_high": 10, "to_low": 1, "to_high": -1)", "result", {0}},
    {"remap", R"("x": 20, "from_low": 0, "from_high": 10, "to_low": 0, "to_high": 1)", "result", {2}},
    {"remap", R"("x": 5, "from_low": 3, "from_high": 3, "to_low": 7, "to_high": 9)", "result", {7}},
    {"floor", R"("x": -1.25)", "result", {-2}},
    {"fraction", R"("x": -1.25)", "result", {0.75}},
    {"modulo", R"("x": -1, "divisor": 3)", "result", {2}},
    {"modulo", R"("x": 1, "divisor": -3)", "result", {-2}},
    {"modulo", R"("x": 1, "divisor": 0)", "result", {0}},
    {"power", R"("base": 2, "exponent": 0.5)", "result", {std::sqrt(2.0)}},
    {"power", R"("base": -2, "exponent": 2)", "result", {0}},
    {"power", R"("base": 0, "exponent": 0)", "result", {1}},
    {"square_root", R"("x": 2)", "result", {std::sqrt(2.0)}},
    {"square_root", R"("x": -2)", "result", {0}},
    {"sine", R"("angle": 2)", "result", {std::sin(2.0)}},
    {"cosine", R"("angle": 2)", "result", {std::cos(2.0)}},
    {"tangent", R"("angle": 1)", "result", {std::tan(1.0)}},
    {"arctangent2", R"("y": -1, "x": -2)", "result", {std::atan2(-1.0, -2.0)}},
    {"arctangent2", R"("y": 0, "x": 0)", "result", {0}},
    {"arcsine", R"("x": 0.5)", "result", {std::asin(0.5)}},
    {"arcsine", R"("x": 7)", "result", {std::asin(1.0)}},
    {"arccosine", R"("x": -0.5)", "result", {std::acos(-0.5)}},
    {"arccosine", R"("x": -7)", "result", {std::acos(-1.0)}},
    {"arctangent", R"("x": -3)", "result", {std::atan(-3.0)}},
    {"to_radians", R"("angle": 90)", "result", {std::asin(1.0)}},
    {"to_degrees", R"("angle": 2)", "result", {114.591559}},
    {"exponential", R"("x": 1)", "result", {std::exp(1.0)}},
    {"logarithm", R"("x": 8, "base": 2)", "result", {3}},
    {"logarithm", R"("x": 8, "base": 1)", "result", {0}},
    {"logarithm", R"("x": 8, "base": -2)", "result", {0}},
    {"hypotenuse", R"("a": -5, "b": 12)", "result", {13}},
    {"reciprocal", R"("x": -4)", "result", {-0.25}},
    {"reciprocal", R"("x": 0)", "result", {0}},
    {"safe_power", R"("base": -3, "exponent": 2)", "result", {-9}},
    {"safe_power", R"("base": 0, "exponent": -2)", "result", {0}},
    {"multiply_add", R"("a": 2, "b": 3, "c": -1)", "result", {5}},
    {"ceiling", R"("x": -1.25)", "result", {-1}},
    {"round", R"("x": -1.5)", "result", {-1}},
    {"round", R"("x": 2.5)", "result", {3}},
    {"truncate", R"("x": -1.75)", "result", {-1}},
    {"sign", R"("x": -1.75)", "result", {-1}},
    {"sign", R"("x": 0)", "result", {0}},
    {"compare", R"("a": 2, "b": 2, "comparison": "less", "yes": 5, "no": 7)", "result", {7}},
    {"compare", R"("a": 2, "b": 2, "comparison": "less_equal", "yes": 5, "no": 7)", "result", {5}},
    {"compare", R"("a": 3, "b": 2, "comparison": "greater", "yes": 5, "no": 7)", "result", {5}},
    {"compare", R"("a": 1, "b": 2, "comparison": "greater_equal", "yes": 5, "no": 7)", "result", {7}},
    {"compare", R"("a": 1, "b": 1.5, "comparison": "equal")", "result", {0}},
    {"compare", R"("a": 1, "b": 1.5, "comparison": "equal", "tolerance": 0.6)", "result", {1}},
    {"height_add", R"("a": 0.1, "b": 0.2)", "height", {0.3}},
    {"height_scale", R"("height": 0.1, "amount": -2)", "height", {-0.2}},
    {"height_mix", R"("a": 0.1, "b": 0.3, "mask": 0.75)", "height", {0.25}},
};
const Case vectors[] = {
    {"combine_vec2", R"("x": 1, "y": 2)", "vector", {1, 2}},
    {"combine_vec3", R"("x": 1, "y": 2, "z": 3)", "vector", {1, 2, 3}},
    {"combine_vec4", R"("x": 1, "y": 2, "z": 3, "w": 4)", "vector", {1, 2, 3, 4}},
    {"separate_vec2", R"("vector": [1, 2])", "y", {2}},
    {"separate_vec3", R"("vector": [1, 2, 3])", "z", {3}},
    {"separate_vec4", R"("vector": {"from": "surface.color0"})", "w", {0.8}},
    {"vec2_add", R"("a": [1, 2], "b": [3, 5])", "vector", {4, 7}},
    {"vec2_scale", R"("vector": [1, 2], "factor": -2)", "vector", {-2, -4}},
    {"vec3_add", R"("a": [1, 2, 3], "b": [3, 5, 7])", "vector", {4, 7, 10}},
    {"vec3_subtract", R"("a": [1, 2, 3], "b": [3, 5, 7])", "vector", {-2, -3, -4}},
    {"vec3_multiply", R"("a": [1, 2, 3], "b": [3, 5, 7])", "vector", {3, 10, 21}},
    {"vec3_scale", R"("vector": [1, 2, 3], "factor": 0.5)", "vector", {0.5, 1, 1.5}},
    {"vec3_mix", R"("a": [0, 0, 4], "b": [4, 8, 0], "mask": 0.25)", "vector", {1, 2, 3}},
    {"dot", R"("a": [1, 2, 3], "b": [4, -5, 6])", "result", {12}},
    {"cross", R"("a": [1, 2, 3], "b": [4, 5, 6])", "vector", {-3, 6, -3}},
    {"length", R"("vector": [2, 3, 6])", "result", {7}},
    {"normalize", R"("vector": [2, 3, 6])", "vector", {2 / 7.0, 3 / 7.0, 6 / 7.0}},
    {"normalize", R"("vector": [0, 0, 0])", "vector", {0, 0, 0}},
    {"distance", R"("a": [1, 1, 1], "b": [3, 4, 7])", "result", {7}},
    {"vec3_minimum", R"("a": [1, 5, 3], "b": [4, 2, 3])", "vector", {1, 2, 3}},
    {"vec3_maximum", R"("a": [1, 5, 3], "b": [4, 2, 3])", "vector", {4, 5, 3}},
    {"vec3_floor", R"("vector": [-1.25, 0, 2.5])", "vector", {-2, 0, 2}},
    {"vec3_fraction", R"("vector": [-1.25, 0, 2.5])", "vector", {0.75, 0, 0.5}},
    {"vec3_absolute", R"("vector": [-1.25, 0, 2.5])", "vector", {1.25, 0, 2.5}},
    {"reflect", R"("vector": [1, 2, -3], "normal": [0, 0, 5])", "vector", {1, 2, 3}},
    {"refract", R"("vector": [3, 0, -4], "ratio": 1)", "vector", {0.6, 0, -0.8}},
    // sin 30 deg / 1.25 = 0.4.
    {"refract", R"("vector": [0.5, 0, -0.8660254], "ratio": 0.8)", "vector", {0.4, 0, -std::sqrt(0.84)}},
    {"refract", R"("vector": [0.8, 0, -0.6], "ratio": 1.5)", "vector", {0, 0, 0}},
    {"rotate", R"("vector": [1, 0, 7], "angle": 90)", "vector", {0, 1, 7}},
    {"rotate", R"("vector": [1, 2, 3], "axis": [1, 1, 1], "angle": 120)", "vector", {3, 1, 2}},
    {"rotate", R"("vector": [1, 2, 3], "axis": [0, 0, 0], "angle": 70)", "vector", {1, 2, 3}},
    {"project", R"("vector": [1, 2, 3], "onto": [0, 2, 0])", "vector", {0, 2, 0}},
    {"project", R"("vector": [1, 2, 3], "onto": [0, 0, 0])", "vector", {0, 0, 0}},
    {"face_forward", R"("vector": [1, 2, 3], "reference": [0, 0, -1])", "vector", {-1, -2, -3}},
    {"face_forward", R"("vector": [1, 2, 3])", "vector", {1, 2, 3}},
    {"uv_transform", R"("scale": [2, 4], "offset": [10, 20])", "uv", {10.6, 22.4}},
    {"uv_transform", R"("scale": [2, 4], "rotation": 90)", "uv", {-2.4, 0.6}},  // scaled first
    {"uv_transform", R"("rotation": 90, "offset": [1, 0])", "uv", {0.4, 0.3}},  // moved last
};
// clang-format on
INSTANTIATE_TEST_SUITE_P(Arithmetic, Numbers, ::testing::ValuesIn(arithmetic));
INSTANTIATE_TEST_SUITE_P(Vectors, Numbers, ::testing::ValuesIn(vectors));

std::vector<double> noise_at(const std::string& in, const char* output,
                             const std::vector<std::array<double, 2>>& points) {
    std::vector<double> numbers;
    for (const auto& lanes : values({one("gradient_noise", in), output}, points))
        numbers.push_back(lanes[0]);
    return numbers;
}

std::vector<std::array<double, 2>> grid(int n, double step) {
    std::vector<std::array<double, 2>> points;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x)
            points.push_back({x * step - 3, y * step + 5});
    return points;
}

TEST(GradientNoise, StaysInItsRangeAndFillsIt) {
    for (const char* octaves : {"1", "4", "8"}) {
        const auto noise = noise_at(R"("scale": 1, "octaves": )" + std::string(octaves), "n.value",
                                    grid(100, 0.37));
        double sum = 0, least = 0, most = 0;
        for (const double v : noise)
            sum += v, least = std::min(least, v), most = std::max(most, v);
        EXPECT_NEAR(sum / 10000, 0, 0.03) << octaves;
        EXPECT_LT(most, 1.05);
        EXPECT_GT(least, -1.05);
        EXPECT_GT(most, 0.35);
        EXPECT_LT(least, -0.35);
    }
}

TEST(GradientNoise, IsZeroAtLatticePointsAndNotBetween) {
    const auto noise = noise_at(R"("scale": 1, "octaves": 1)", "n.value",
                                {{0, 0}, {-3, 7}, {120, -55}, {0.5, 0.5}});
    EXPECT_NEAR(noise[0], 0, 1e-9);
    EXPECT_NEAR(noise[1], 0, 1e-9);
    EXPECT_NEAR(noise[2], 0, 1e-9);
    EXPECT_GT(std::abs(noise[3]), 1e-3);
}

TEST(GradientNoise, IsContinuousAcrossCells) {
    const auto noise = noise_at(R"("scale": 1, "octaves": 1)", "n.value",
                                {{2 - 1e-7, 0.4}, {2 + 1e-7, 0.4}, {0.3, -1e-7}, {0.3, 1e-7}});
    EXPECT_NEAR(noise[0], noise[1], 1e-6);
    EXPECT_NEAR(noise[2], noise[3], 1e-6);
}

TEST(GradientNoise, BumpIsTheSlopeOfItsHeight) {
    const std::string noise =
        one("gradient_noise", R"("scale": 3, "octaves": 3, "amplitude": 0.5)") +
        R"(, "g": {"type": "gradient_from_height",
                                         "in": {"height": {"from": "n.height"}}})";
    for (const auto& [x, y] :
         std::vector<std::array<double, 2>>{{0.3, 0.6}, {-1.7, 2.2}, {9, 4.4}}) {
        const double d = 1e-5;
        const auto h =
            values({noise, "n.height"}, {{x + d, y}, {x - d, y}, {x, y + d}, {x, y - d}});
        const auto g = value({noise, "g.gradient"}, x, y);
        EXPECT_NEAR(g[0], (h[0][0] - h[1][0]) / (2 * d), 1e-4);
        EXPECT_NEAR(g[1], (h[2][0] - h[3][0]) / (2 * d), 1e-4);
        EXPECT_NEAR(g[2], 0, 1e-9);
    }
}

TEST(GradientNoise, OneOctaveIgnoresGainAndLacunarity) {
    const auto a = noise_at(R"("octaves": 1, "gain": 0)", "n.value", {{0.31, 0.62}});
    const auto b =
        noise_at(R"("octaves": 1, "gain": 1, "lacunarity": 3)", "n.value", {{0.31, 0.62}});
    const auto c = noise_at(R"("octaves": 2, "gain": 1)", "n.value", {{0.31, 0.62}});
    EXPECT_EQ(a, b);
    EXPECT_NE(a, c);
}

}  // namespace
}  // namespace wrinkle::test
