// Tests of masks: against Snell's law, sampled means, tilts of known planes and displaced spheres.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/number.h"
#include "nodes/solid.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

// A direction at an angle from y, towards z.
std::array<double, 3> leaning(double angle) {
    return {0, std::cos(angle * degree), std::sin(angle * degree)};
}
double with_normal(const std::string& nodes, const char* output, double angle) {
    Scene scene{nodes, output};
    scene.normal = leaning(angle);
    return value(scene)[0];
}

TEST(DirectionMask, HasItsEdgeAtTheAngle) {
    for (const auto& [angle, softness] : {std::pair{45.0, 20.0}, {100.0, 30.0}, {20.0, 1.0}}) {
        const std::string node =
            one("direction_mask", R"("axis": [0, 3, 0], "angle": )" + std::to_string(angle) +
                                      ", \"softness\": " + std::to_string(softness));
        const auto at = [&](double tilt) { return with_normal(node, "n.value", tilt); };
        EXPECT_EQ(at(0), 1);
        EXPECT_NEAR(at(angle - 0.5 * softness), 1, 1e-5);
        EXPECT_LT(at(angle - 0.4 * softness), 0.99);
        const double middle = 0.5 * (std::cos((angle - 0.5 * softness) * degree) +
                                     std::cos((angle + 0.5 * softness) * degree));
        EXPECT_NEAR(at(std::acos(middle) / degree), 0.5, 1e-4);
        EXPECT_GT(at(angle + 0.4 * softness), 0.01);
        EXPECT_NEAR(at(angle + 0.5 * softness), 0, 1e-5);
        EXPECT_EQ(at(180), 0);
    }
}

TEST(DirectionMask, OfAllAnglesIsOne) {
    const std::string all = one("direction_mask", R"("angle": 180, "softness": 0)");
    const std::string none = one("direction_mask", R"("angle": 0, "softness": 0)");
    for (const double tilt : {1.0, 90.0, 179.0}) {
        EXPECT_EQ(with_normal(all, "n.value", tilt), 1) << tilt;
        EXPECT_EQ(with_normal(none, "n.value", tilt), 0) << tilt;
    }
    EXPECT_EQ(with_normal(one("direction_mask", R"("axis": [0, 0, 0])"), "n.value", 0), 0);
}

// On a unit sphere, the mask as a height displaces it: the bump is that of the displaced sphere.
TEST(DirectionMask, HasTheSlopeOfASphere) {
    const std::string nodes =
        one("direction_mask", R"("softness": 40)") +
        R"(, "h": {"type": "height_scale", "in": {"height": {"from": "n.value"}, "amount": 0.1}},
        "r": {"type": "resolve", "in": {"gradient": {"from": "h.height"}}})";
    size_t bumped = 0;
    for (const Place& place : on_sphere(300)) {
        const Vector got = vector_of(value_on({nodes, "r.normal"}, place));
        const auto height = [](Vector p) {
            const double low = std::cos(65 * degree), high = std::cos(25 * degree);
            const double t = std::min(std::max((p.y - low) / (high - low), 0.0), 1.0);
            return 0.1 * t * t * (3 - 2 * t);
        };
        // The height is small, so the normal differs by the curvature of the sphere: a factor
        // 1 + height of the slope.
        const Vector truth = displaced_on_sphere(place.position, height);
        EXPECT_NEAR(dot(got, truth), 1, 2e-3);
        bumped += dot(got, place.normal) < 0.998;
    }
    EXPECT_GT(bumped, 30U);
}

// An edge without softness rises over the pixel in which the normal changes.
TEST(DirectionMask, IsAsWideAsAPixel) {
    const std::string node = one("direction_mask", R"("angle": 90, "softness": 0)");
    for (const double tilt : {-0.04, 0.0, 0.03, 0.3}) {
        const Vector up = unit({0, tilt, 1});
        const double got = value_on({node, "n.value"}, {up, up}, 0.1)[0];
        if (tilt == 0) {
            EXPECT_NEAR(got, 0.5, 1e-4);
        } else if (tilt == 0.3) {
            EXPECT_EQ(got, 1);
        } else {
            EXPECT_GT(got * (1 - got), 0.01);
        }
    }
}

// A height that rises by the tangent of the tilt, along u.
std::string ramp_of(double tilt) {
    return R"("x": {"type": "uv_transform", "in": {"scale": [)" +
           std::to_string(std::tan(tilt * degree)) +
           R"(, 0]}}, "s": {"type": "separate_vec2", "in": {"vector": {"from": "x.uv"}}}, )";
}

TEST(SlopeMask, IsOneOnSteeperBumps) {
    const std::string node =
        one("slope_mask", R"("gradient": {"from": "s.x"}, "angle": 30, "softness": 10)");
    const auto at = [&](double tilt, const char* output) {
        return value({ramp_of(tilt) + node, output})[0];
    };
    for (const double tilt : {0.0, 20.0, 24.9}) {
        EXPECT_NEAR(at(tilt, "n.value"), 0, 1e-3) << tilt;
        EXPECT_NEAR(at(tilt, "n.flat"), 1, 1e-3) << tilt;
    }
    for (const double tilt : {35.1, 60.0, 85.0})
        EXPECT_NEAR(at(tilt, "n.value"), 1, 1e-3) << tilt;
    EXPECT_NEAR(at(30, "n.value"), 0.5, 0.07);
    EXPECT_LT(at(28, "n.value"), at(32, "n.value"));
}

TEST(SlopeMask, HasNoSlope) {
    const std::string nodes =
        R"("w": {"type": "waves", "in": {"amplitude": 0.1}}, )" +
        one("slope_mask", R"("gradient": {"from": "w.height"})") +
        R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.value"}}})";
    EXPECT_EQ(value({nodes, "g.gradient"}), (std::vector<double>{0, 0, 0}));
}

TEST(HeightMask, IsTheMeanOfARampOverThePixel) {
    const auto ramp = [](double low, double high) {
        return [=](double h) { return std::min(std::max((h - low) / (high - low), 0.0), 1.0); };
    };
    const std::string rising = R"("low": 0.2, "high": 0.6)", falling = R"("low": 0.6, "high": 0.2)";
    for (const double h : {-0.3, 0.1, 0.25, 0.4, 0.55, 0.68, 2.0})
        for (const double width : {0.0, 0.05, 0.3, 1.5}) {
            EXPECT_NEAR(numbers_through("height_mask", "height", rising, "value", {h}, width)[0],
                        box_mean(ramp(0.2, 0.6), h, width), 1e-3)
                << h << " " << width;
            EXPECT_NEAR(numbers_through("height_mask", "height", falling, "value", {h}, width)[0],
                        box_mean(ramp(0.6, 0.2), h, width), 1e-3)
                << h << " " << width;
        }
}

TEST(HeightMask, OfAnEmptyRangeIsAnEdge) {
    const std::string in = R"("low": 0.2, "high": 0.2)";
    const auto at = [&](double h, double width) {
        return numbers_through("height_mask", "height", in, "value", {h}, width)[0];
    };
    EXPECT_EQ(at(0.1, 0), 0);
    EXPECT_EQ(at(0.3, 0), 1);
    EXPECT_NEAR(at(0.25, 0.4), 0.625, 1e-3);
}

// d mask / du = 2.5 d height / du inside of the range, 0 outside of it.
TEST(HeightMask, HasTheSlopeOfTheHeight) {
    const std::string nodes =
        R"("s": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}}, )" +
        one("height_mask", R"("height": {"from": "s.x"}, "low": 0.2, "high": 0.6)") +
        R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.value"}}})";
    EXPECT_NEAR(value({nodes, "g.gradient"}, 0.3, 0.5)[0], 2.5, 1e-3);
    EXPECT_NEAR(value({nodes, "g.gradient"}, 0.1, 0.5)[0], 0, 1e-6);
    EXPECT_NEAR(value({nodes, "g.gradient"}, 0.9, 0.5)[0], 0, 1e-6);
}

TEST(EdgeWear, IsWhereAReliefIsAboveOrBelowASmootherOne) {
    const auto at = [](double height, double width, const char* output) {
        return numbers_through("edge_wear", "height",
                               R"("smooth": 0.5, "level": 0.1, "softness": 0.04)", output, {height},
                               width)[0];
    };
    EXPECT_EQ(at(0.63, 0, "edges"), 1);
    EXPECT_EQ(at(0.57, 0, "edges"), 0);
    EXPECT_NEAR(at(0.6, 0, "edges"), 0.5, 1e-4);
    EXPECT_EQ(at(0.63, 0, "cavities"), 0);
    EXPECT_EQ(at(0.37, 0, "cavities"), 1);
    EXPECT_NEAR(at(0.4, 0, "cavities"), 0.5, 1e-4);
    EXPECT_NEAR(at(0.65, 0.2, "edges"), 0.84375, 1e-4);  // smoothstep of 3/4
}

// The mean of x^2 - 3 y^2 over a circle around a point is (1 - 3) / 2 times the square of its
// radius more than the value there: the saddle is convex.
const char saddle[] = R"("u": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
    "xx": {"type": "multiply", "in": {"a": {"from": "u.x"}, "b": {"from": "u.x"}}},
    "yy": {"type": "multiply", "in": {"a": {"from": "u.y"}, "b": {"from": "u.y"}}},
    "saddle": {"type": "multiply_add", "in": {"a": {"from": "yy.result"}, "b": -3,
        "c": {"from": "xx.result"}}}, )";

TEST(Curvature, IsMinusTheLaplacian) {
    const auto at = [](double span, const char* output, double factor = 1) {
        const std::string scaled =
            R"("h": {"type": "multiply", "in": {"a": {"from": "saddle.result"}, "b": )" +
            std::to_string(factor) + "}}, ";
        return value(
            {saddle + scaled +
                 one("curvature", R"("height": {"from": "h.result"}, "level": 0.02, "span": )" +
                                      std::to_string(span)),
             output})[0];
    };
    for (const double span : {0.05, 0.1}) {
        EXPECT_NEAR(at(span, "n.above"), span * span, 1e-9);
        EXPECT_NEAR(at(span, "n.convex"), span * span / 0.02, 1e-6);
        EXPECT_EQ(at(span, "n.concave"), 0);
        EXPECT_NEAR(at(span, "n.concave", -1), span * span / 0.02, 1e-6);
        EXPECT_EQ(at(span, "n.convex", -1), 0);
    }
    EXPECT_EQ(at(0.3, "n.convex"), 1);
}

// A span below a pixel counts as a pixel.
TEST(Curvature, LooksAtLeastAPixelFar) {
    const std::string nodes =
        saddle + one("curvature", R"("height": {"from": "saddle.result"}, "span": 0.0001)");
    EXPECT_NEAR(value({nodes, "n.above"})[0], pixel * pixel, 1e-12);
}

TEST(Curvature, HasAnExactSlope) {
    constexpr double step = 1e-5;
    const std::string nodes =
        R"("w": {"type": "waves", "in": {"scale": 3, "amplitude": 0.1}}, )" +
        one("curvature", R"("height": {"from": "w.height"}, "span": 0.03)") +
        R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.above"}}})";
    for (const std::array<double, 2>& p : {std::array{0.31, 0.62}, {0.87, -0.4}, {-2.3, 1.9}}) {
        const auto at = [&](double dx, double dy) {
            return value({nodes, "n.above"}, p[0] + dx, p[1] + dy)[0];
        };
        const auto slope = value({nodes, "g.gradient"}, p[0], p[1]);
        EXPECT_NEAR(slope[0], (at(step, 0) - at(-step, 0)) / (2 * step), 1e-6);
        EXPECT_NEAR(slope[1], (at(0, step) - at(0, -step)) / (2 * step), 1e-6);
        EXPECT_GT(std::fabs(slope[0]) + std::fabs(slope[1]), 0.05);
    }
}

double seen_at(const std::string& node, double cosine) {
    Scene scene{node, "n.value"};
    scene.view = {std::sqrt(1 - cosine * cosine), 0, cosine};
    return value(scene)[0];
}

// Fresnel's sines and tangents of the angles of Snell's law.
double reflected(double cosine, double ior) {
    const double in = std::acos(cosine), sine = std::sin(in) / ior;
    if (sine >= 1) return 1;
    const double out = std::asin(sine);
    const double s = std::sin(in - out) / std::sin(in + out);
    const double p = std::tan(in - out) / std::tan(in + out);
    return 0.5 * (s * s + p * p);
}

TEST(Fresnel, IsThatOfSnellsLaw) {
    for (const double ior : {1.1, 1.33, 1.5, 2.4, 0.7})
        for (const double cosine : {0.05, 0.1, 0.2, 0.5, 0.8, 0.97})
            EXPECT_NEAR(seen_at(one("fresnel", "\"ior\": " + std::to_string(ior)), cosine),
                        reflected(cosine, ior), 2e-5)
                << ior << " " << cosine;
    for (const auto& [cosine, part] :
         {std::pair{1.0, 0.04}, {0.5, 0.08919}, {0.2, 0.33889}, {0.1, 0.57159}})
        EXPECT_NEAR(seen_at(one("fresnel"), cosine), part, 1e-5);
    EXPECT_NEAR(seen_at(one("fresnel"), 0), 1, 1e-5);
    EXPECT_EQ(seen_at(one("fresnel", R"("ior": 1)"), 0.3), 0);
}

TEST(Fresnel, ByAPowerIsSchlicks) {
    for (const auto& [cosine, part] :
         {std::pair{1.0, 0.04}, {0.5, 0.07}, {0.2, 0.35457}, {0.1, 0.60687}})
        EXPECT_NEAR(seen_at(one("fresnel", R"("model": "power")"), cosine), part, 1e-5);
}

TEST(Facing, IsThatOfBlender) {
    const auto at = [](double blend, double cosine) {
        return seen_at(one("facing", "\"blend\": " + std::to_string(blend)), cosine);
    };
    EXPECT_NEAR(at(0.5, 0.3), 0.7, 1e-5);
    EXPECT_NEAR(at(0.25, 0.36), 0.4, 1e-5);
    EXPECT_NEAR(at(0.75, 0.6), 0.64, 1e-5);
    EXPECT_NEAR(at(0, 0.6), 0, 1e-5);
    EXPECT_NEAR(at(0.5, 0), 1, 1e-5);
    Scene behind{one("facing"), "n.value"};
    behind.view = {0, 0.8, -0.6};
    EXPECT_NEAR(value(behind)[0], 0.4, 1e-5);
}

}  // namespace
}  // namespace wrinkle::test
