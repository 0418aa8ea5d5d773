// Tests of the slope variance that filtered procedural heights report: far away it is the mean
// square of the slopes close up.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "nodes/relief.h"
#include "nodes/solid.h"

namespace wrinkle::test {
namespace {

constexpr double gentle = 0.001;  // so small that normals vary as slopes do

std::string with_variance(const std::string& node) {
    return node + R"(, "g": {"type": "gradient_from_height", "in": {"height":
        {"from": "n.height"}}}, "rough": {"type": "bump_roughness",
        "in": {"gradient": {"from": "g.gradient"}, "roughness": 0}})";
}

// Evaluates a height in space on planes of random directions, with pixels `size` wide.
std::vector<std::vector<double>> read_in_space(const std::string& node, const std::string& port,
                                               double size, int count) {
    std::mt19937 random(5);
    const auto number = [&] { return random() / 2147483648.0 - 1; };
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        const Vector position = Vector{number(), number(), number()} * 100;
        places.push_back({position, unit({number(), number(), number()})});
    }
    return values_on({with_variance(node), port}, places, size);
}

double slope_variance_near(const std::string& node) {
    double sum = 0;
    const auto slopes = read_in_space(node, "g.gradient", 1e-4, 20000);
    for (const auto& slope : slopes)
        sum += dot(vector_of(slope), vector_of(slope)) / 20000;
    return sum;
}

struct Slopes {
    double near, far;  // variances over both axes, in cells
    double sloped;     // share of the area
};

Slopes of_pattern(const std::string& type, const std::string& in) {
    constexpr int count = 40000;
    double near = 0, sloped = 0;
    for (const Point& slope : read(type, in, random_cells(count, 240)).slope) {
        const double square = slope[0] * slope[0] + slope[1] * slope[1];
        near += square / count;
        sloped += (square > 1e-12) / double(count);
    }
    constexpr int cells = 40;  // under a pixel
    const std::string node =
        one(type, "\"" + density_of(type) + "\": " + std::to_string(cells / pixel) +
                      R"(, "amplitude": )" + "2e-8" + (in.empty() ? "" : ", ") + in);
    constexpr double steep = 2e-8 * cells / pixel;
    const auto far = values({with_variance(node), "rough.variance"}, {{0.1, 0.2}});
    return {near, far.empty() ? 0 : far[0][0] / (steep * steep), sloped};
}

struct Filtered {
    const char *type, *in;
    double tolerance;  // a sample varies, and constants are fitted
};

// clang-format off
const Filtered patterns[] = {
    {"waves", "", 0.01}, {"waves", R"("shape": "rings")", 0.01}, {"waves", R"("count": 1)", 0.01},
    {"pyramids", "", 0.03}, {"pyramids", R"("base": 0.8)", 0.03},
    {"domes", "", 0.03}, {"domes", R"("base": 0.5, "roundness": 0.4)", 0.03},
    {"brick", "", 0.03}, {"brick", R"("aspect": 1, "bevel": 0.3, "mortar": 0)", 0.03},
    {"hexagons", "", 0.05}, {"hexagons", R"("bevel": 0.05)", 0.05},
    {"voronoi", "", 0.03}, {"voronoi", R"("jitter": 0)", 0.03},
    {"voronoi", R"("jitter": 0.5, "bevel": 0.05)", 0.03},
    {"bricks", "", 0.03}, {"bricks", R"("bond": "english")", 0.03},
    {"bricks", R"("bond": "flemish")", 0.03}, {"bricks", R"("bond": "planks")", 0.03},
    {"bricks", R"("bond": "herringbone")", 0.03},
    {"bricks", R"("bond": "basket_weave", "aspect": 3)", 0.03},
    {"bricks", R"("bond": "spanish")", 0.03},
    {"weave", "", 0.12}, {"weave", R"("weave": "twill", "width": 0.7)", 0.12},
    {"weave", R"("weave": "twill_3_1", "width": 0.6)", 0.12},
    {"weave", R"("weave": "satin_5", "width": 0.5)", 0.12},
    {"weave", R"("weave": "satin_8", "width": 1)", 0.12}};
const Filtered noises[] = {
    {"gradient_noise", R"("octaves": 1)", 0.03}, {"gradient_noise", R"("octaves": 3)", 0.03},
    {"simplex_noise", "", 0.03}, {"value_noise", "", 0.03},
    {"fbm", R"("basis": "simplex")", 0.03}, {"fbm", R"("basis": "value", "gain": 0.7)", 0.03},
    {"turbulence", "", 0.03}, {"turbulence", R"("basis": "value")", 0.03},
    {"ridged", "", 0.05}, {"ridged", R"("basis": "simplex")", 0.05},
    {"ridged", R"("basis": "value")", 0.05},
    {"worley_noise", "", 0.03}, {"worley_noise", R"("distance": "f2")", 0.03},
    {"worley_noise", R"("distance": "f2_minus_f1")", 0.05},
    {"worley_noise", R"("distance": "f2_minus_f1", "jitter": 0.5)", 0.05}};
// clang-format on

TEST(LostSlope, OfPatternsIsTheVarianceOfTheirSlopesCloseUp) {
    for (const Filtered& pattern : patterns) {
        const auto [near, far, sloped] = of_pattern(pattern.type, pattern.in);
        EXPECT_NEAR(far / (near * sloped), 1, pattern.tolerance)
            << pattern.type << " " << pattern.in;
    }
}

TEST(LostSlope, OfNoisesIsTheVarianceOfTheirSlopesCloseUp) {
    for (const Filtered& noise : noises) {
        const std::string node =
            one(noise.type, R"("scale": 3, "amplitude": )" + std::to_string(gentle) +
                                (*noise.in ? ", " : "") + noise.in);
        const double near = slope_variance_near(node);
        const auto far = read_in_space(node, "rough.variance", 20, 1);
        ASSERT_EQ(far.size(), 1U) << noise.type;
        EXPECT_NEAR(far[0][0] / near, 1, noise.tolerance) << noise.type << " " << noise.in;
    }
}

// The threads of a satin's warp lie along v, so slopes vary along u. The oracle has the axes apart.
TEST(BumpRoughness, IsWidestWhereSlopesVaryMost) {
    const std::string in = R"("weave": "satin_5", "width": 0.8)";
    double u = 0, v = 0;
    for (const Point& slope : read("weave", in, random_cells(40000, 240)).slope) {
        u += slope[0] * slope[0] / 40000;
        v += slope[1] * slope[1] / 40000;
    }
    const std::string node = one("weave", R"("scale": 40960, "amplitude": 2e-8, )" + in);
    const auto far = [&](const std::string& port) {
        return values({with_variance(node), "rough." + port}, {{0.1, 0.2}})[0];
    };
    const std::vector<double> tangent = far("tangent");
    EXPECT_NEAR(std::fabs(tangent[0]), 1, 1e-6);
    // Both variances are fitted to a tenth; the base is smooth.
    EXPECT_NEAR(far("anisotropy")[0], 1 - std::sqrt(v / u), 0.05);
}

}  // namespace
}  // namespace wrinkle::test
