// Tests of ramps and curves against numbers of other programs and against means by samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "nodes/blender_numbers.h"
#include "nodes/number.h"

namespace wrinkle::test {
namespace {

const std::string four_stops =
    R"("stops": 4, "position_2": 0.25, "position_3": 0.6, "color_2": [0.8, 0.2, 0],
       "color_3": [0.1, 0.4, 0.9], "interpolation": )";

std::vector<std::vector<double>> colors(const std::string& in, const std::vector<double>& factors,
                                        double width = 0) {
    return through("ramp", "factor", in, "color", factors, width);
}

void expect_colors(const std::string& in, const std::vector<double>& factors,
                   const std::vector<std::vector<double>>& expected) {
    const auto got = colors(in, factors);
    ASSERT_EQ(got.size(), expected.size());
    for (size_t i = 0; i < got.size(); ++i)
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[i][c], expected[i][c], 1e-5) << in << " at " << factors[i];
}

// ColorRamp.evaluate() of Blender 3.4.1.
TEST(Ramp, HasTheColorsOfBlender) {
    expect_colors(four_stops + "\"linear\"", {0, 0.1, 0.4, 0.75},
                  {{0, 0, 0}, {0.32, 0.08, 0}, {0.5, 0.285714, 0.385714}, {0.4375, 0.625, 0.9375}});
    expect_colors(four_stops + "\"ease\"", {0, 0.1, 0.4, 0.75},
                  {{0, 0, 0},
                   {0.2816, 0.0704, 0},
                   {0.524490, 0.278717, 0.354227},
                   {0.384766, 0.589844, 0.931641}});
    expect_colors(four_stops + "\"constant\"", {0.1, 0.3, 0.7, 1.2},
                  {{0, 0, 0}, {0.8, 0.2, 0}, {0.1, 0.4, 0.9}, {1, 1, 1}});
}

TEST(Ramp, HasTheColorsOfBlenderEverywhere) {
    for (const auto& [interpolation, at, color] : blender_ramps)
        expect_colors(four_stops + '"' + interpolation + '"', {at}, {{color.begin(), color.end()}});
}

// PchipInterpolator of SciPy 1.10.1, of each component.
TEST(Ramp, IsSmoothAsPchip) {
    expect_colors(four_stops + "\"smooth\"", {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.8, 0.95},
                  {{0.254933, 0.044064, 0},
                   {0.4748, 0.086479, 0},
                   {0.759733, 0.164829, 0},
                   {0.761224, 0.230781, 0.047012},
                   {0.52449, 0.281574, 0.337176},
                   {0.238776, 0.332275, 0.697892},
                   {0.155937, 0.502432, 0.941735},
                   {0.324167, 0.641209, 0.973209},
                   {0.788424, 0.90232, 0.998242}});
}

TEST(Ramp, HasTheEndColorsOutside) {
    for (const char* mode : {"constant", "linear", "ease", "smooth"})
        expect_colors(four_stops + "\"" + mode + "\", \"color_1\": [0.3, 0.2, 0.1]", {-5, -0.1, 7},
                      {{0.3, 0.2, 0.1}, {0.3, 0.2, 0.1}, {1, 1, 1}});
}

TEST(Ramp, IsTheMeanOverThePixel) {
    EXPECT_NEAR(colors(four_stops + "\"linear\"", {0.24}, 0.3)[0][0], 0.59813, 1e-5);
    EXPECT_NEAR(colors(four_stops + "\"ease\"", {0.24}, 0.3)[0][0], 0.63935, 1e-5);
    EXPECT_NEAR(colors(four_stops + "\"constant\"", {0.24}, 0.3)[0][0], 0.37333, 1e-5);
    std::mt19937 random(7);
    const auto number = [&] { return random() / 4294967296.0; };
    for (const char* mode : {"constant", "linear", "ease", "smooth"})
        for (int k = 0; k < 12; ++k) {
            const double x = 1.4 * number() - 0.2, width = 1.5 * number() * number() + 0.002;
            std::vector<double> samples;
            box_mean([&](double at) { return samples.push_back(at), 0.0; }, x, width);
            std::vector<double> mean(3);
            for (const auto& color : colors(four_stops + "\"" + mode + "\"", samples))
                for (size_t c = 0; c < 3; ++c)
                    mean[c] += color[c] / 4096;
            const auto got = colors(four_stops + "\"" + mode + "\"", {x}, width)[0];
            // At a jump, one sample of 4096 is 2.4e-4.
            for (size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(got[c], mean[c], mode == std::string("constant") ? 3e-4 : 1e-4)
                    << mode << " at " << x << " over " << width;
        }
}

TEST(Ramp, WithoutDetailIsTheMeanOfItsRange) {
    for (const char* mode : {"constant", "linear", "ease", "smooth"}) {
        const std::string in = four_stops + "\"" + mode + "\"";
        const auto far = colors(in + ", \"detail\": 0", {0.1, 0.9});
        const auto mean = colors(in, {0.5}, 1.0)[0];
        for (size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(far[0][c], mean[c], 1e-9);
            EXPECT_NEAR(far[1][c], mean[c], 1e-9);
        }
    }
}

// Halfway from black to white: half the lightness of either space.
TEST(Ramp, MixesInItsSpace) {
    expect_colors(R"("space": "linear")", {0.5}, {{0.5, 0.5, 0.5}});
    expect_colors(R"("space": "display")", {0.5}, {{0.214041, 0.214041, 0.214041}});
    expect_colors(R"("space": "oklab")", {0.5}, {{0.125, 0.125, 0.125}});
    // Pure hues of OKLab: red .627955 .224863 .125846, green .866440 -.233888 .179498.
    const auto mixed =
        colors(R"("space": "oklab", "color_1": [1, 0, 0], "color_2": [0, 1, 0])", {0, 0.5, 1});
    const double l = 0.7471975, a = -0.0045125, b = 0.152672;
    const double cone = std::pow(l + 0.3963377774 * a + 0.2158037573 * b, 3),
                 m = std::pow(l - 0.1055613458 * a - 0.0638541728 * b, 3),
                 s = std::pow(l - 0.0894841775 * a - 1.2914855480 * b, 3);
    EXPECT_NEAR(mixed[1][0], 4.0767416621 * cone - 3.3077115913 * m + 0.2309699292 * s, 1e-5);
    EXPECT_NEAR(mixed[0][0], 1, 1e-5);
    EXPECT_NEAR(mixed[2][1], 1, 1e-5);
}

TEST(Ramp, GivesItsLuminance) {
    const std::string in = four_stops + "\"linear\"";
    const double value = numbers_through("ramp", "factor", in, "value", {0.1})[0];
    EXPECT_NEAR(value, 0.32 * 0.2126 + 0.08 * 0.7152, 1e-6);
}

// A position below the one before is a hard edge there; later stops do not move.
TEST(Ramp, OutOfOrderHasAHardEdge) {
    for (const char* mode : {"constant", "linear", "ease", "smooth"}) {
        const auto got = colors(R"("stops": 3, "position_1": 0.6, "position_2": 0.3,
                                   "color_1": [0.2, 0.2, 0.2], "color_2": [0.7, 0.7, 0.7], "interpolation": ")" +
                                    std::string(mode) + "\"",
                                {0.5999, 0.6001, 1.1});
        EXPECT_NEAR(got[0][0], 0.2, 1e-9) << mode;
        EXPECT_NEAR(got[1][0], 0.7, 1e-3) << mode;
        EXPECT_NEAR(got[2][0], 1, 1e-9) << mode;
    }
}

const std::string four_points =
    R"("points": 4, "point_2": [0.25, 0.1], "point_3": [0.6, 0.8], "interpolation": )";

std::vector<double> curve(const std::string& mode, const std::vector<double>& at,
                          double width = 0) {
    return numbers_through("curve", "value", four_points + "\"" + mode + "\"", "value", at, width);
}

// PCHIP as SciPy defines it.
TEST(Curve, HasTheNumbersOfPchip) {
    const auto got = curve("smooth", {0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9});
    const double expected[] = {0.01977, 0.06903, 0.15743, 0.37721, 0.63298, 0.87686, 0.98395};
    for (size_t i = 0; i < got.size(); ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-5);
    const double d = 1e-4;
    const auto around = curve("smooth", {0.25 - d, 0.25 + d, 0.6 - d, 0.6 + d, d, 1 - d});
    EXPECT_NEAR((around[1] - around[0]) / (2 * d), 0.64286, 1e-2);
    EXPECT_NEAR((around[3] - around[2]) / (2 * d), 0.81081, 1e-2);
    EXPECT_NEAR(around[4] / d, 0, 1e-2);
    EXPECT_NEAR((1 - around[5]) / d, 0, 1e-2);
}

// PchipInterpolator of SciPy 1.10.1, where both ends have a slope and secants change their sign.
TEST(Curve, TurnsAsPchipDoes) {
    const auto got = numbers_through("curve", "value",
                                     R"("points": 5, "point_1": [0, 0.2], "point_2": [0.1, 0.9],
               "point_3": [0.5, 0.3], "point_4": [0.6, 0.35], "point_5": [1, 0.1])",
                                     "value", {0.03, 0.07, 0.2, 0.3, 0.4, 0.55, 0.7, 0.9});
    const double expected[] = {0.47909, 0.80361, 0.80625, 0.6, 0.39375, 0.325, 0.339531, 0.224844};
    for (size_t i = 0; i < got.size(); ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-5) << i;
}

// Blender evaluates a table of 256 entries.
TEST(Curve, IsStraightAsThatOfBlender) {
    for (const auto& [interpolation, at, expected] : blender_curves)
        EXPECT_NEAR(curve(interpolation, {at})[0], expected, 2e-3) << at;
}

TEST(Curve, IsTheMeanOverThePixel) {
    for (const char* mode : {"constant", "linear", "ease", "smooth"})
        for (const auto& [x, width] : {std::pair{0.24, 0.3}, {0.9, 0.5}, {0.6, 0.02}, {0.4, 3.0}}) {
            std::vector<double> samples;
            box_mean([&](double at) { return samples.push_back(at), 0.0; }, x, width);
            double mean = 0;
            for (const double value : curve(mode, samples))
                mean += value / 4096;
            EXPECT_NEAR(curve(mode, {x}, width)[0], mean, 1e-4) << mode;
        }
}

// A position below the one before counts as equal to it, and so is a hard edge.
TEST(Curve, OutOfOrderHasAHardEdge) {
    for (const char* mode : {"constant", "linear", "ease", "smooth"}) {
        const auto got = numbers_through(
            "curve", "value",
            R"("points": 3, "point_1": [0.6, 0.2], "point_2": [0.3, 0.7], "point_3": [1, 0.9],
               "interpolation": ")" +
                std::string(mode) + "\"",
            "value", {-2, 0.5999, 0.6001, 1, 5});
        EXPECT_NEAR(got[0], 0.2, 1e-9) << mode;
        EXPECT_NEAR(got[1], 0.2, 1e-9) << mode;
        EXPECT_NEAR(got[2], 0.7, 1e-3) << mode;
        EXPECT_NEAR(got[4], 0.9, 1e-9) << mode;
    }
}

TEST(Curve, NeverOvershoots) {
    std::vector<double> at;
    for (int k = 0; k <= 1000; ++k)
        at.push_back(k / 1000.0);
    const auto got = curve("smooth", at);
    EXPECT_TRUE(std::is_sorted(got.begin(), got.end()));
    const auto [least, most] = std::minmax_element(got.begin(), got.end());
    EXPECT_GE(*least, 0);
    EXPECT_LE(*most, 1);
}

}  // namespace
}  // namespace wrinkle::test
