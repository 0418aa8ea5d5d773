// Tests of operators on gradients and heights. On the plane a volume gradient (a, b, c) is the bump
// (a, b, 0), so that expected numbers are plain vectors.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

std::string link(const std::string& source) {
    return R"({"from": ")" + source + R"("})";
}
std::string bump(const std::string& id, const std::string& volume) {
    return "\"" + id + R"(": {"type": "gradient_from_volume", "in": {"volume": )" + volume + "}}, ";
}
// Node "n" of this type applied to a = (1, 0.5, 0) and b = (-0.25, 2, 0); `more` has further
// members of its "in".
std::string of_two(const std::string& type, const std::string& more = "") {
    return bump("a", "[1, 0.5, 7]") + bump("b", "[-0.25, 2, -3]") +
           one(type, R"("a": {"from": "a.gradient"}, "b": {"from": "b.gradient"})" + more);
}
std::string of_one(const std::string& type, const std::string& volume,
                   const std::string& more = "") {
    return bump("a", volume) + one(type, R"("gradient": {"from": "a.gradient"})" + more);
}
std::string height_of_x(const std::string& type, const std::string& in) {
    return R"("x": {"type": "separate_vec3", "in": {"vector": {"from": "surface.position"}}}, )" +
           one(type, in) +
           R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.height"}}})";
}

void expect_lanes(const std::vector<double>& got, const std::vector<double>& expected,
                  double tolerance = 1e-12) {
    ASSERT_EQ(got.size(), expected.size());
    for (size_t i = 0; i < got.size(); ++i)
        EXPECT_NEAR(got[i], expected[i], tolerance) << "lane " << i;
}
void expect_gradient(const std::string& nodes, const std::vector<double>& expected,
                     double tolerance = 1e-12) {
    expect_lanes(value({nodes, "n.gradient"}), expected, tolerance);
}

TEST(Operators, AddAndSubtract) {
    expect_gradient(of_two("gradient_add"), {0.75, 2.5, 0});
    expect_gradient(of_two("gradient_subtract"), {1.25, -1.5, 0});
    const std::string nothing =
        bump("a", "[1, 0.5, 7]") +
        one("gradient_subtract", R"("a": {"from": "a.gradient"}, "b": {"from": "a.gradient"})");
    expect_gradient(nothing, {0, 0, 0}, 0);
}

TEST(Operators, InvertIsTheOpposite) {
    expect_gradient(of_one("gradient_invert", "[1, 0.5, 7]"), {-1, -0.5, 0}, 0);
}

TEST(Operators, AMaskEndsAtTheOneAndTheOther) {
    expect_gradient(of_two("gradient_mix", R"(, "mask": 0)"), {1, 0.5, 0}, 0);
    expect_gradient(of_two("gradient_mix", R"(, "mask": 1)"), {-0.25, 2, 0}, 0);
    expect_gradient(of_two("gradient_mix", R"(, "mask": 0.25)"), {0.6875, 0.875, 0});
}

// a and b of each node that mixes by a mask.
struct Mixing {
    const char *type, *a, *b, *output;
    std::vector<const char*> values = {"0.1", "0.7"};
};
const Mixing mixings[] = {{"mix", "a", "b", "result"},
                          {"height_mix", "a", "b", "height"},
                          {"float_blend", "base", "top", "value"},
                          {"vec3_mix", "a", "b", "vector", {"[0.1, -3, 7e-5]", "[0.7, 11, 0.3]"}},
                          {"blend", "base", "top", "color", {"[0.1, 0.9, 0.003]", "[0.7, 0, 1]"}},
                          {"gradient_mix",
                           "a",
                           "b",
                           "gradient",
                           {R"({"from": "p.gradient"})", R"({"from": "q.gradient"})"}}};

std::vector<double> mixed(const Mixing& of, size_t a, const std::string& mask) {
    const std::string in = std::string("\"") + of.a + "\": " + of.values[a] + ", \"" + of.b +
                           "\": " + of.values[1 - a] + ", \"mask\": " + mask;
    return value({bump("p", "[0.1, 3.3, 7]") + bump("q", "[-0.7, 0.003, 1]") + one(of.type, in),
                  std::string("n.") + of.output});
}

// Bit for bit: a - (a - b) is not b in floating point.
TEST(Masks, ZeroAndOneReturnTheirInput) {
    for (const Mixing& each : mixings) {
        EXPECT_EQ(mixed(each, 0, "0"), mixed(each, 1, "1")) << each.type;
        EXPECT_EQ(mixed(each, 0, "1"), mixed(each, 1, "0")) << each.type;
        EXPECT_NE(mixed(each, 0, "0"), mixed(each, 0, "1")) << each.type;
    }
    EXPECT_EQ(mixed(mixings[0], 0, "1")[0], 0.7);
    EXPECT_EQ(mixed(mixings[0], 0, "0")[0], 0.1);
}

TEST(Masks, OfTheOtherOrderAreOneMinusTheMask) {
    for (const Mixing& each : mixings)
        for (const auto& [mask, rest] : {std::pair{"0.3", "0.7"}, std::pair{"0.95", "0.05"}})
            expect_lanes(mixed(each, 0, mask), mixed(each, 1, rest), 1e-6);
}

TEST(Operators, OverHidesWhatIsBelow) {
    expect_gradient(of_two("gradient_over"), {-0.25, 2, 0}, 0);
    expect_gradient(of_two("gradient_over", R"(, "coverage": 0)"), {1, 0.5, 0}, 0);
    expect_gradient(of_two("gradient_over", R"(, "amount": 0)"), {0, 0, 0}, 0);
    expect_gradient(of_two("gradient_over", R"(, "amount": 2, "coverage": 0.5)"), {0.25, 2.25, 0});
    const std::string three = R"("three": {"type": "add", "in": {"a": 1, "b": 2}}, )";
    expect_gradient(three + of_two("gradient_over", R"(, "coverage": {"from": "three.result"})"),
                    {-0.25, 2, 0}, 0);
}

TEST(Operators, ASlopeIsLimitedAndKeepsItsDirection) {
    const std::string limit = R"(, "max_tilt": 45)";
    expect_gradient(of_one("gradient_clamp_slope", "[3, -4, 0]", limit), {0.6, -0.8, 0});
    expect_gradient(of_one("gradient_clamp_slope", "[0.6, -0.7, 0]", limit), {0.6, -0.7, 0}, 0);
    expect_gradient(of_one("gradient_clamp_slope", "[0, 0, 0]", R"(, "max_tilt": 0)"), {0, 0, 0});
    for (const double tilt : {1.0, 30.0, 80.0, 89.0}) {
        const std::string steep = of_one("gradient_clamp_slope", "[400, 300, 0]",
                                         R"(, "max_tilt": )" + std::to_string(tilt));
        const std::string measured = steep +
                                     R"(, "t": {"type": "gradient_tilt", "in": {"gradient": )" +
                                     link("n.gradient") + "}}";
        EXPECT_NEAR(value({measured, "t.tilt"})[0], tilt, 1e-9);
    }
}

// Unity computes 1/z of a two-channel map as rsqrt(max(1 - x^2 - y^2, 2^-7)).
TEST(Operators, UnitysLimitOfTwoChannelMapsIsATilt) {
    const Image map = painted(64, [](double u, double v) {
        const double turn = 2 * std::numbers::pi * v, r = u * 128 / 127;
        return std::array{0.5 + 0.5 * r * std::cos(turn), 0.5 + 0.5 * r * std::sin(turn), 0.0};
    });
    const std::string nodes =
        R"("m": {"type": "tangent_normal_map", "in": {"image":
               {"file": "textures/weave_normal.png", "encoding": "normal_rg"}}},
           "n": {"type": "gradient_clamp_slope", "in": {"gradient": {"from": "m.gradient"},
               "max_tilt": 84.95}},
           "t": {"type": "gradient_tilt", "in": {"gradient": {"from": "n.gradient"}}},
           "free": {"type": "gradient_tilt", "in": {"gradient": {"from": "m.gradient"}}})";
    double beyond = 0;
    for (int i = 0; i < 64; ++i) {
        const double u = (i + 0.5) / 64, v = 19.5 / 64, r = u * 128 / 127;
        const double unity = r / std::sqrt(std::max(1 - r * r, 1.0 / 128));
        const double tilt = std::atan(unity) * 180 / std::numbers::pi;
        EXPECT_NEAR(value({nodes, "t.tilt", map}, u, v)[0], tilt, 0.05) << r;
        beyond = std::max(beyond, value({nodes, "free.tilt", map}, u, v)[0] - tilt);
    }
    EXPECT_GT(beyond, 1) << "nothing here is steep enough to be limited";
}

TEST(Operators, TiltIsTheAngleOfTheNormals) {
    const std::string tilt = of_one("gradient_tilt", "[3, -4, 9]");
    EXPECT_NEAR(value({tilt, "n.slope"})[0], 5, 1e-12);
    EXPECT_NEAR(value({tilt, "n.tilt"})[0], 78.690067525979785, 1e-9);
    const std::string resolved =
        bump("a", "[3, -4, 9]") +
        one("normal_angle", R"("a": {"from": "surface.normal"}, "b": {"from": "a.gradient"})");
    EXPECT_NEAR(value({resolved, "n.angle"})[0], 78.690067525979785, 1e-9);
    const auto apart = [](const char* a, const char* b) {
        return value(
            {one("normal_angle", R"("a": )" + std::string(a) + R"(, "b": )" + b), "n.angle"})[0];
    };
    EXPECT_NEAR(apart("[0, 0, 2]", "[0, 3, 0]"), 90, 1e-12);
    EXPECT_NEAR(apart("[1, 2, 2]", "[-1, -2, -2]"), 180, 1e-12);
    EXPECT_NEAR(apart("[1, 0, 0]", "[1, 1e-5, 0]"), 5.729577951e-4, 1e-12);  // acos would give 0
    EXPECT_EQ(apart("[0, 0, 0]", "[0, 3, 0]"), 0);
}

std::string composed(const std::string& in) {
    return bump("a", "[1, 0.5, 7]") + bump("b", "[-0.25, 2, -3]") + bump("c", "[4, 8, 0]") +
           one("gradient_compositor",
               R"("base": {"from": "a.gradient"}, "gradient1": {"from": "b.gradient"},
                  "gradient2": {"from": "c.gradient"})" +
                   in);
}

TEST(Compositor, LaysLayersOnEachOther) {
    expect_gradient(composed(""), {4.75, 10.5, 0});
    expect_gradient(composed(R"(, "layers": 1)"), {0.75, 2.5, 0});
    expect_gradient(composed(R"(, "mode1": "subtract", "amount2": 0.5, "mask2": 0.5)"),
                    {2.25, 0.5, 0});
    expect_gradient(composed(R"(, "mode1": "subtract", "mask1": 0.5, "layers": 1)"),
                    {1.125, -0.5, 0});
    expect_gradient(composed(R"(, "mode2": "over")"), {4, 8, 0}, 0);
    expect_gradient(composed(R"(, "mode2": "over", "amount2": 2, "mask2": 0.25)"),
                    {0.75 * 0.75 + 2, 2.5 * 0.75 + 4, 0});
    expect_gradient(composed(R"(, "mode1": "over", "mode2": "subtract")"), {-4.25, -6, 0});
    expect_gradient(composed(R"(, "layers": 4)"), {4.75, 10.5, 0});  // unconnected layers are flat
}

TEST(Compositor, AddedLayersMayChangePlaces) {
    const std::string in = R"("base": {"from": "a.gradient"}, )";
    const auto order = [&](const char* first, const char* second) {
        return value(
            {bump("a", "[1, 0.5, 7]") + bump("b", "[-0.25, 2, -3]") + bump("c", "[4, 8, 0]") +
                 one("gradient_compositor",
                     in + R"("gradient1": )" + link(first) + R"(, "gradient2": )" + link(second)),
             "n.gradient"});
    };
    expect_lanes(order("b.gradient", "c.gradient"), order("c.gradient", "b.gradient"));
}

TEST(Masks, OfHeightsAddTheirSlopeAndThoseOfGradientsDoNot) {
    const std::string mask = R"("mask": {"from": "x.x"})";
    const std::string heights = height_of_x("height_mix", R"("a": 0, "b": 0.5, )" + mask);
    expect_lanes(value({heights, "g.gradient"}), {0.5, 0, 0});
    const std::string gradients =
        R"("x": {"type": "separate_vec3", "in": {"vector": {"from": "surface.position"}}},
           "level": {"type": "gradient_from_height", "in": {"height": 0.5}}, )" +
        one("gradient_mix", R"("b": {"from": "level.gradient"}, )" + mask);
    expect_gradient(gradients, {0, 0, 0}, 0);
}

// Half of a detail is half as steep, and the layers below are unchanged.
TEST(Masks, OfADetailLeaveTheBaseAlone) {
    const std::string half = R"(, "mask1": 0.5, "layers": 1)";
    expect_gradient(composed(half), {1 - 0.125, 0.5 + 1, 0});
}

// A height adds to a normal map directly; blending normals would require converting it to a normal.
TEST(Operators, AHeightGoesOverANormalMap) {
    const std::string both =
        R"("x": {"type": "separate_vec3", "in": {"vector": {"from": "surface.position"}}},
           "map": {"type": "gradient_from_tangent_normal", "in": {"normal": [-0.6, 0, 0.8]}}, )" +
        one("gradient_add", R"("a": {"from": "map.gradient"}, "b": {"from": "x.y"})");
    expect_gradient(both, {0.75, 1, 0});
}

double height(const std::string& type, const std::string& in, double x = 0.3) {
    return value({height_of_x(type, in), "n.height"}, x)[0];
}
double slope(const std::string& type, const std::string& in, double x) {
    return value({height_of_x(type, in), "g.gradient"}, x)[0];
}

TEST(Heights, AreSubtractedInvertedAndRemapped) {
    EXPECT_NEAR(height("height_subtract", R"("a": 0.5, "b": {"from": "x.x"})"), 0.2, 1e-12);
    EXPECT_NEAR(height("height_invert", R"("height": {"from": "x.x"})"), -0.3, 1e-12);
    EXPECT_NEAR(height("height_invert", R"("height": {"from": "x.x"}, "level": 0.5)"), 0.7, 1e-12);
    const std::string range =
        R"("height": {"from": "x.x"}, "from_low": 0.2, "from_high": 0.6, "to_low": 1, "to_high": 3)";
    EXPECT_NEAR(height("height_remap", range), 1.5, 1e-12);
    EXPECT_NEAR(slope("height_remap", range, 0.3), 5, 1e-9);
    EXPECT_NEAR(height("height_remap", range, 0.9), 3, 1e-12);
    EXPECT_NEAR(slope("height_remap", range, 0.9), 0, 1e-12);
    const std::string open = range + R"(, "clamped": false)";
    EXPECT_NEAR(height("height_remap", open, 0.9), 4.5, 1e-12);
    EXPECT_NEAR(height("height_remap", R"("height": 3, "from_low": 1, "from_high": 1)"), 0, 1e-12);
}

TEST(Heights, TheHigherAndTheLowerOne) {
    const std::string in = R"("a": {"from": "x.x"}, "b": 0.25)";
    EXPECT_EQ(height("height_max", in, 0.3), 0.3);
    EXPECT_EQ(height("height_max", in, 0.2), 0.25);
    EXPECT_EQ(height("height_min", in, 0.3), 0.25);
    EXPECT_EQ(height("height_min", in, 0.2), 0.2);
    EXPECT_NEAR(slope("height_max", in, 0.3), 1, 1e-12);
    EXPECT_NEAR(slope("height_max", in, 0.2), 0, 1e-12);
}

TEST(Heights, AreRoundedIntoEachOther) {
    const std::string in = R"("a": {"from": "x.x"}, "b": 0.25, "smoothness": 0.1)";
    for (const double x : {0.0, 0.14, 0.36, 0.7}) {
        EXPECT_NEAR(height("height_max", in, x), std::max(x, 0.25), 1e-12) << x;
        EXPECT_NEAR(height("height_min", in, x), std::min(x, 0.25), 1e-12) << x;
    }
    EXPECT_NEAR(slope("height_max", in, 0.250001), 0.5, 1e-4);
    EXPECT_NEAR(slope("height_max", in, 0.249999), 0.5, 1e-4);
    for (double x = 0.12; x < 0.4; x += 0.013) {
        const double step = 1e-6;
        for (const char* type : {"height_max", "height_min"}) {
            const double numeric =
                (height(type, in, x + step) - height(type, in, x - step)) / (2 * step);
            EXPECT_NEAR(slope(type, in, x), numeric, 1e-5) << type << " at " << x;
        }
        // The maximum and the minimum have a constant sum.
        EXPECT_NEAR(height("height_max", in, x) + height("height_min", in, x), x + 0.25, 1e-12);
    }
}

}  // namespace
}  // namespace wrinkle::test
