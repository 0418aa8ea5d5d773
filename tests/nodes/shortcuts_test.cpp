// Tests of common shortcuts against the correct normal: closed forms and counts that verify the
// nodes' documentation.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "lower/conversion.h"
#include "nodes/normals.h"
#include "nodes/plane.h"
#include "support/linked_nodes.h"

namespace wrinkle::test {
namespace {

constexpr double pi = std::numbers::pi;

std::string json(const Normal& v) {
    return "[" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " + std::to_string(v[2]) +
           "]";
}
double tilt_of(const std::vector<double>& normal) {
    return angle_between({normal.at(0), normal.at(1), normal.at(2)}, {0, 0, 1});
}

// Hints do not recommend a node that demonstrates an error.
TEST(Shortcuts, HintsOfWrongWiresNameNone) {
    for (uint32_t from = 1; from <= port_type_count; ++from)
        for (uint32_t to = 1; to <= port_type_count; ++to)
            EXPECT_EQ(
                alternative(static_cast<PortType>(from), static_cast<PortType>(to), linked_nodes())
                    .find("compare_"),
                std::string::npos);
}

// Volume gradients are normally distributed here, with mean length 1.6.
std::vector<Pair> random_volumes(size_t count) {
    std::mt19937 random(3);
    const auto even = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
    std::vector<Pair> volumes(count);
    for (Pair& volume : volumes)
        for (double& lane : volume.base)
            lane = std::sqrt(-2 * std::log(even())) * std::cos(2 * pi * even());
    return volumes;
}
double facing_inward(const std::vector<Normal>& normals) {
    size_t inward = 0;
    for (const Normal& normal : normals)
        inward += normal[2] < 0 ? 1 : 0;
    return static_cast<double>(inward) / static_cast<double>(normals.size());
}

TEST(Perlin, TiltsByThePartAlongTheNormalToo) {
    const auto volumes = random_volumes(20000);
    const auto theirs = read(one("compare_perlin", R"("volume": {"from": "surface.position"})"),
                             "n.bumped", volumes);
    const auto ours = read(
        R"("g": {"type": "gradient_from_volume", "in": {"volume": {"from": "surface.position"}}}, )" +
            one("resolve", R"("gradient": {"from": "g.gradient"})"),
        "n.normal", volumes);
    EXPECT_NEAR(angles(ours, theirs).mean, 23.1, 1);  // published for lengths of about 1.7
    EXPECT_NEAR(facing_inward(theirs), 0.161, 0.01);  // if the normal component exceeds 1
    EXPECT_EQ(facing_inward(ours), 0);
    // A height that grows only outward is not a bump.
    EXPECT_NEAR(tilt_of(value({one("compare_perlin", R"("volume": [0, 0, 2])"), "n.bumped"})), 180,
                1e-9);
}

// A volume gradient; a wire from it to a normal resolves it.
std::string bumped(double slope) {
    return R"("g": {"type": "gradient_from_volume", "in": {"volume": [)" + std::to_string(slope) +
           ", 0, 0]}}, ";
}

TEST(WeightedNormals, AFlatLayerHalvesTheTilt) {
    const std::string flat =
        bumped(std::sqrt(3)) + one("compare_weighted_normals", R"("a": {"from": "g.gradient"})");
    EXPECT_NEAR(tilt_of(value({flat, "n.normal"})), 30, 1e-4);
    const std::string none =
        bumped(std::sqrt(3)) +
        one("compare_weighted_normals", R"("a": {"from": "g.gradient"}, "weight_b": 0)");
    EXPECT_NEAR(tilt_of(value({none, "n.normal"})), 60, 1e-4);
}

TEST(BlenderStrength, HalvesTheAngleAndNotTheSlope) {
    const auto tilt = [](const char* amount) {
        return tilt_of(value({bumped(1) + one("compare_blender_strength",
                                              R"("bumped": {"from": "g.gradient"}, "amount": )" +
                                                  std::string(amount)),
                              "n.normal"}));
    };
    EXPECT_NEAR(tilt("0"), 0, 1e-9);
    EXPECT_NEAR(tilt("0.5"), 22.5, 1e-4);  // a slope of 0.5 tilts by 26.57
    EXPECT_NEAR(tilt("1"), 45, 1e-4);
}

TEST(NormalStrength, IsNoFactorOfTheSlope) {
    const auto tilt = [](const char* rule, const char* amount) {
        return tilt_of(value({one("compare_normal_strength",
                                  R"("normal": )" + json(tilted(45, 30)) + R"(, "amount": )" +
                                      amount + R"(, "rule": ")" + rule + "\""),
                              "n.scaled"}));
    };
    EXPECT_NEAR(tilt("unity", "0.5"), 22.5, 1e-3);
    EXPECT_NEAR(tilt("unity", "2"), std::atan(2) * 180 / pi, 1e-3);  // equal above 1
    EXPECT_NEAR(tilt("rebuilt", "0.5"), std::asin(std::sqrt(0.125)) * 180 / pi, 1e-3);
    EXPECT_NEAR(tilt("rebuilt", "2"), 90, 1e-3);
    for (const char* rule : {"unity", "rebuilt"})
        EXPECT_NEAR(tilt(rule, "1"), 45, 1e-3);
}

// The plane with u to the left: pixels and normals as before.
PointSet mirrored_points(const Scene& scene) {
    PointSet points = plane_points(scene, {{0.3, 0.6}});
    for (const Variant variant : {Variant::value, Variant::dx, Variant::dy})
        points.at(SurfaceInput::uv0_, variant)[0] *= -1;
    return points;
}

TEST(EngineBasis, TurnsHillsIntoDentsOnMirroredUvs) {
    const std::string normal = R"("normal": [0.6, 0, 0.8])";
    const Scene theirs{one("compare_engine_basis", normal), "n.bumped"};
    const Scene ours{
        R"("g": {"type": "gradient_from_tangent_normal", "in": {"frame": "derived", )" + normal +
            "}}, " + one("resolve", R"("gradient": {"from": "g.gradient"})"),
        "n.normal"};
    EXPECT_NEAR(value(theirs)[0], 0.6, 1e-9);
    EXPECT_NEAR(value(ours)[0], 0.6, 1e-9);
    // A map with a slope along +u tilts along -x there.
    EXPECT_NEAR(values(ours, mirrored_points(ours))[0][0], -0.6, 1e-9);
    EXPECT_NEAR(values(theirs, mirrored_points(theirs))[0][0], 0.6, 1e-9);
}

TEST(EngineBasis, IsNotInTheTangentPlaneOfTheInterpolatedNormal) {
    const Scene theirs{
        one("compare_engine_basis", R"("normal": [1, 0, 1])"), "n.bumped", {}, {0.6, 0, 0.8}};
    // The face's own x axis plus the interpolated normal: 63.4 degrees, where 45 away is 81.9.
    const Normal got{1.6, 0, 0.8};
    const auto lanes = value(theirs);
    EXPECT_NEAR(angle_between({lanes[0], lanes[1], lanes[2]}, got), 0, 1e-6);
}

std::string screen_wave(const char* more) {
    return R"("uv": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
              "wave": {"type": "sine", "in": {"angle": {"from": "uv.x"}}}, )" +
           one("compare_screen_height", R"("height": {"from": "wave.result"})" + std::string(more));
}

TEST(ScreenHeight, IsTheDifferenceToTheNextPixel) {
    const double x = 0.3, slope = (std::sin(x + pixel) - std::sin(x)) / pixel;
    const auto normal = value({screen_wave(""), "n.normal"}, x);
    EXPECT_NEAR(-normal[0] / normal[2], slope, 1e-9);
    EXPECT_GE(std::fabs(slope - std::cos(x)), 1e-4);  // different from the slope
}

TEST(ScreenHeight, OfUnitPixelsFadesAsTheViewerComesCloser) {
    const double x = 0.3, rise = std::sin(x + pixel) - std::sin(x);
    const auto normal = value({screen_wave(R"(, "pixel": "unit")"), "n.normal"}, x);
    EXPECT_NEAR(-normal[0] / normal[2], rise, 1e-9);
}

}  // namespace
}  // namespace wrinkle::test
