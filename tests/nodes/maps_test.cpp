// Tests of maps with textures of known slopes, on a plane where a gradient is (dh/dx, dh/dy, 0).
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/plane.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

void expect_vector(const std::vector<double>& got, std::array<double, 3> expected,
                   double tolerance = 1e-4) {
    ASSERT_EQ(got.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(got[i], expected[i], tolerance) << "lane " << i;
}

const Image ramp = painted(64, [](double u, double v) {
    return std::array{0.25 * u + 0.5 * v, 0.0, 0.0};
});

TEST(HeightMap, HeightIsAmplitudeAboveTheMidlevel) {
    const std::string map = one("height_map", R"("amplitude": 2, "midlevel": 0.25)");
    EXPECT_NEAR(value({map, "n.height", ramp})[0], 2 * (0.25 * 0.3 + 0.5 * 0.6 - 0.25), 1e-5);
}

TEST(HeightMap, BumpIsItsSlopeInEveryScaleAndFrame) {
    for (const char* how :
         {R"("scale": "surface")", R"("scale": "surface", "frame": "exact")", R"("scale": "unit")",
          R"("scale": "unit", "frame": "vertex")", R"("scale": "unit", "frame": "derived")",
          R"("scale": "unit", "frame": "guess", "direction": [1, 0, 0])"}) {
        SCOPED_TRACE(how);
        const std::string map = one("height_map", R"("amplitude": 2, )" + std::string(how));
        expect_vector(value({map, "n.gradient", ramp}), {0.5, 1, 0}, 2e-3);
    }
}

TEST(HeightMap, TilingSteepensASurfaceHeightAndNotAUnitOne) {
    const auto tiled = [](const char* scale) {
        return R"("t": {"type": "uv_transform", "in": {"scale": [0.5, 0.5]}}, )" +
               one("height_map", R"("amplitude": 2, "uv": {"from": "t.uv"}, "scale": ")" +
                                     std::string(scale) + "\"");
    };
    expect_vector(value({tiled("surface"), "n.gradient", ramp}), {0.25, 0.5, 0}, 2e-3);
    expect_vector(value({tiled("unit"), "n.gradient", ramp}), {0.5, 1, 0}, 2e-3);
}

TEST(DerivativeMap, HoldsSlopesPerUvUnitOrPerTexel) {
    const Image slopes = painted(8, [](double, double) { return std::array{0.75, 0.375, 0.0}; });
    const auto map = [](const char* in) { return one("derivative_map", in); };
    expect_vector(value({map(""), "n.gradient", slopes}), {0.5, -0.25, 0});
    expect_vector(value({map(R"("strength": -2)"), "n.gradient", slopes}), {-1, 0.5, 0});
    expect_vector(value({map(R"("per": "texel")"), "n.gradient", slopes}), {4, -2, 0});
}

TEST(TangentNormalMap, SlopesAreTheRatioOfItsComponents) {
    // (-0.6, 0.2, 0.5) before encoding: dh/du = 1.2, dh/dv = -0.4
    const Image normals = painted(8, [](double, double) { return std::array{0.2, 0.6, 0.75}; });
    const auto map = [](const char* in) { return one("tangent_normal_map", in); };
    expect_vector(value({map(""), "n.gradient", normals}), {1.2, -0.4, 0});
    expect_vector(value({map(R"("strength": 0.5)"), "n.gradient", normals}), {0.6, -0.2, 0});
    expect_vector(
        value({map(R"("frame": "derived", "uv": {"from": "surface.uv1"})"), "n.gradient", normals}),
        {1.2, -0.4, 0});
    expect_vector(
        value({map(R"("scale": "surface", "uv": {"from": "surface.uv1"})"), "n.gradient", normals}),
        {2.4, -0.8, 0});
}

TEST(TangentNormalMap, TheGuessedTangentIsTheGivenDirection) {
    const Image normals = painted(8, [](double, double) { return std::array{0.2, 0.5, 0.75}; });
    const std::string map =
        one("tangent_normal_map", R"("frame": "guess", "direction": [0, 3, 5])");
    expect_vector(value({map, "n.gradient", normals}), {0, 1.2, 0});  // along y, flattened
}

TEST(ObjectNormalMap, LeadsToItsNormal) {
    // (0.6, 0, 0.8): the resolved normal is the map's.
    const Image normals = painted(8, [](double, double) { return std::array{0.8, 0.5, 0.9}; });
    const std::string map =
        one("object_normal_map") +
        R"(, "r": {"type": "resolve", "in": {"gradient": {"from": "n.gradient"}}})";
    expect_vector(value({map, "r.normal", normals}), {0.6, 0, 0.8});
}

TEST(ObjectNormalMap, InwardNormalsAreMirroredOrReversed) {
    // (0.6, 0, -0.8) on the normal (0, 0, 1).
    const Image normals = painted(8, [](double, double) { return std::array{0.8, 0.5, 0.1}; });
    const auto resolved = [](const char* facing) {
        return one("object_normal_map", R"("facing": ")" + std::string(facing) + "\"") +
               R"(, "r": {"type": "resolve", "in": {"gradient": {"from": "n.gradient"}}})";
    };
    expect_vector(value({resolved("toward"), "r.normal", normals}), {0.6, 0, 0.8});
    expect_vector(value({resolved("opposite"), "r.normal", normals}), {-0.6, 0, 0.8});
}

TEST(Image, GivesItsChannels) {
    const Image colors = painted(8, [](double, double) { return std::array{0.25, 0.5, 1.0}; });
    const std::string linear =
        R"("n": {"type": "image", "in": {"image": {"file": "textures/weave_normal.png", "encoding": "linear"}}})";
    expect_vector(value({linear, "n.color", colors}), {0.25, 0.5, 1});
    EXPECT_NEAR(value({linear, "n.green", colors})[0], 0.5, 1e-6);
    EXPECT_NEAR(value({linear, "n.alpha", colors})[0], 1, 1e-6);
    EXPECT_NEAR(value({one("image"), "n.green", colors})[0], 0.21404, 1e-4);  // sRGB 0.5
}

const std::string two_bumps =
    R"("h": {"type": "ripples", "in": {"frequency": 1, "centre": [0, 0, 0], "amplitude": 0.1}},
       "a": {"type": "gradient_from_height", "in": {"height": {"from": "h.height"}}},
       "b": {"type": "gradient_from_volume", "in": {"volume": [0.2, -0.4, 7]}}, )";

TEST(Gradients, AddScaleAndMix) {
    const auto a = value({two_bumps + one("resolve"), "a.gradient"});
    const double r = std::hypot(0.3, 0.6);
    const double slope =
        -0.1 * full_circle * std::sin(full_circle * r);  // slope of a cosine along the radius
    expect_vector(a, {slope * 0.3 / r, slope * 0.6 / r, 0}, 1e-6);
    const std::string both = R"("a": {"from": "a.gradient"}, "b": {"from": "b.gradient"})";
    const auto sum = value({two_bumps + one("gradient_add", both), "n.gradient"});
    expect_vector(sum, {a[0] + 0.2, a[1] - 0.4, 0}, 1e-6);
    const auto mix =
        value({two_bumps + one("gradient_mix", both + R"(, "mask": 0.25)"), "n.gradient"});
    expect_vector(mix, {0.75 * a[0] + 0.05, 0.75 * a[1] - 0.1, 0}, 1e-6);
    const std::string half = R"("gradient": {"from": "b.gradient"}, "amount": -0.5)";
    expect_vector(value({two_bumps + one("gradient_scale", half), "n.gradient"}), {-0.1, 0.2, 0});
}

TEST(Gradients, ResolveTurnsTheNormalAgainstTheSlope) {
    const std::string up = R"("gradient": {"from": "b.gradient"})";
    const double length = std::sqrt(1 + 0.2 * 0.2 + 0.4 * 0.4);
    expect_vector(value({two_bumps + one("resolve", up), "n.normal"}),
                  {-0.2 / length, 0.4 / length, 1 / length}, 1e-6);
}

TEST(Gradients, ANormalBecomesTheBumpThatLeadsToIt) {
    const std::string normal = one("gradient_from_normal", R"("normal": [0.2, -0.4, 2])");
    expect_vector(value({normal, "n.gradient"}), {-0.1, 0.2, 0});
}

TEST(Gradients, ABumpOnAResolvedNormalIsTangentToIt) {
    const std::string nodes =
        two_bumps + R"("r": {"type": "resolve", "in": {"gradient": {"from": "b.gradient"}}}, )" +
        one("gradient_from_volume", R"("volume": [1, 2, 3], "base": {"from": "r.normal"})") +
        R"(, "top": {"type": "resolve", "in": {"gradient": {"from": "n.gradient"}}})";
    const auto n = value({nodes, "r.normal"});
    const auto g = value({nodes, "n.gradient"});
    EXPECT_NEAR(n[0] * g[0] + n[1] * g[1] + n[2] * g[2], 0, 1e-9);
    EXPECT_GT(std::hypot(g[0], g[1], g[2]), 1);
    const double length = std::hypot(n[0] - g[0], n[1] - g[1], n[2] - g[2]);
    expect_vector(value({nodes, "top.normal"}),
                  {(n[0] - g[0]) / length, (n[1] - g[1]) / length, (n[2] - g[2]) / length}, 1e-6);
}

TEST(Gradients, BumpsOfTwoBasesDoNotAdd) {
    const std::string nodes =
        two_bumps +
        R"("r": {"type": "resolve", "in": {"gradient": {"from": "b.gradient"}}},
           "c": {"type": "gradient_from_volume",
                 "in": {"volume": [1, 2, 3], "base": {"from": "r.normal"}}}, )" +
        one("gradient_add", R"("a": {"from": "a.gradient"}, "b": {"from": "c.gradient"})");
    EXPECT_NE(problems(nodes, "n.gradient").find("different bases"), std::string::npos);
}

}  // namespace
}  // namespace wrinkle::test
