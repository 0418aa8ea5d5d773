// Tests of shapes against outlines made of many points, and of their masks and bevels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "nodes/number.h"
#include "nodes/outline.h"

namespace wrinkle::test {
namespace {

TEST(Shape, IsAsFarAsItsOutline) {
    std::vector<Point2> circle;
    add_arc(circle, {0.5, 0.5}, 0.3, 0, 2 * half_turn);
    expect_outline("sd_circle", "", circle);
    std::vector<Point2> box;
    for (int k = 0; k < 4; ++k) {
        const double x = k == 0 || k == 3 ? 0.2 : -0.2, y = k < 2 ? 0.1 : -0.1;
        add_arc(box, {0.5 + x, 0.5 + y}, 0.1, k * half_turn / 2, half_turn / 2);
    }
    expect_outline("sd_box", "\"radius\": 0.1", box);
    expect_outline("sd_box", "\"radius\": 0, \"size\": [0.4, 0.2], \"rotation\": 90",
                   {{0.4, 0.3}, {0.6, 0.3}, {0.6, 0.7}, {0.4, 0.7}});
    std::vector<Point2> segment;
    add_arc(segment, {0.8, 0.5}, 0.1, -half_turn / 2, half_turn);
    add_arc(segment, {0.2, 0.5}, 0.1, half_turn / 2, half_turn);
    expect_outline("sd_segment", "", segment);
    for (const int sides : {3, 5, 8}) {
        // A side is up, so the first corner is half a side further.
        auto corners = polar(2 * sides, [&](int) { return 0.3 / std::cos(half_turn / sides); });
        std::vector<Point2> polygon;
        for (size_t k = 1; k < corners.size(); k += 2)
            polygon.push_back(corners[k]);
        expect_outline("sd_polygon", "\"sides\": " + std::to_string(sides), polygon);
    }
    // The inner corners are where the edges of two points meet.
    for (const double pointedness : {0.0, 0.5}) {
        const double half = half_turn / 5, slant = half_turn / (2 + 3 * pointedness);
        const double inner = 0.4 * (std::cos(half) - std::sin(half) / std::tan(slant));
        expect_outline("sd_star", "\"pointedness\": " + std::to_string(pointedness),
                       polar(10, [&](int k) { return k % 2 ? inner : 0.4; }));
    }
    std::vector<Point2> arc;
    add_arc(arc, {0.5, 0.5}, 0.35, half_turn / 6, 2 * half_turn / 3);
    add_arc(arc, {0.5 - 0.3 * std::cos(half_turn / 6), 0.5 + 0.15}, 0.05, 5 * half_turn / 6,
            half_turn);
    add_arc(arc, {0.5, 0.5}, 0.25, 5 * half_turn / 6, -2 * half_turn / 3);
    add_arc(arc, {0.5 + 0.3 * std::cos(half_turn / 6), 0.5 + 0.15}, 0.05, half_turn / 6 + half_turn,
            half_turn);
    expect_outline("sd_arc", "\"angle\": 120", arc);
}

TEST(Shape, OfARingIsTwoCircles) {
    for (const auto& [x, d] :
         {std::pair{0.5, 0.25}, std::pair{0.72, 0.03}, std::pair{0.8, -0.05}, std::pair{0.95, 0.1}})
        EXPECT_NEAR(value({one("sd_ring"), "n.distance"}, x, 0.5)[0], d, 1e-6);
}

// Right at the edge; nearby off by the square of the distance.
TEST(Shape, OfAnEllipseIsRightAtItsEdge) {
    std::vector<Point2> outline;
    for (int k = 0; k < 4000; ++k)
        outline.push_back({0.5 + 0.3 * std::cos(2 * half_turn * k / 4000),
                           0.5 + 0.2 * std::sin(2 * half_turn * k / 4000)});
    for (const Point2& p : random_places(400)) {
        const double truth = to_outline(outline, p);
        if (std::fabs(truth) > 0.04) continue;
        EXPECT_NEAR(value({one("sd_ellipse"), "n.distance"}, p[0], p[1])[0], truth,
                    3 * truth * truth + 1e-4);
    }
    EXPECT_NEAR(value({one("sd_ellipse"), "n.distance"}, 0.5, 0.5)[0], -0.2, 1e-6);
}

TEST(Shape, HasASlopeOfOne) {
    for (const char* type :
         {"sd_circle", "sd_ring", "sd_box", "sd_segment", "sd_polygon", "sd_star", "sd_arc"})
        expect_slope_of_one(type);
}

double joined(double a, double b, const std::string& mode, double band, const char* output,
              const std::string& seam = "quadratic") {
    return value({one("shape_combine", "\"a\": " + std::to_string(a) +
                                           ", \"b\": " + std::to_string(b) + ", \"mode\": \"" +
                                           mode + "\", \"smoothness\": " + std::to_string(band) +
                                           ", \"seam\": \"" + seam + "\""),
                  std::string("n.") + output})[0];
}

// Lines cross each side of a square in its middle, and are a quarter circle from there.
TEST(Truchet, JoinsTheMiddlesOfSides) {
    const std::string node = one("truchet", R"("scale": 1, "width": 0)");
    std::set<bool> turned;
    for (int k = 0; k < 20; ++k) {
        for (const auto& [x, y] : {std::pair{0.5, 0.0}, std::pair{0.5, 1.0}, std::pair{0.0, 0.5}})
            EXPECT_NEAR(value({node, "n.distance"}, k + x, y)[0], 0, 1e-6);
        const double x = k + 0.5 * std::sqrt(0.5), y = 0.5 * std::sqrt(0.5);
        turned.insert(value({node, "n.distance"}, x, y)[0] < 1e-6);
        EXPECT_NEAR(value({node, "n.distance"}, k + 0.5, 0.5)[0], std::sqrt(0.5) - 0.5, 1e-6);
    }
    EXPECT_EQ(turned.size(), 2U);
}

TEST(Truchet, HasNumbersOfItsSquares) {
    const std::string node = one("truchet", R"("scale": 4)");
    const auto at = [&](const char* output, double x) { return value({node, output}, x, 0.3); };
    EXPECT_EQ(at("n.cell", 0.6), (std::vector<double>{2, 1}));
    EXPECT_EQ(at("n.center", 0.6), (std::vector<double>{0.625, 0.375}));
    EXPECT_NEAR(at("n.local", 0.6)[0], -0.1, 1e-6);
    EXPECT_NEAR(at("n.local", 0.6)[1], -0.3, 1e-6);
    EXPECT_EQ(at("n.random", 0.6), at("n.random", 0.7));
    EXPECT_NE(at("n.random", 0.6), at("n.random", 0.8));
    EXPECT_EQ(at("n.detail", 0.6)[0], 1);
    EXPECT_EQ(value({one("truchet", R"("scale": 2000)"), "n.detail"})[0], 0);
}

TEST(ShapeCombine, IsThatOfSets) {
    for (const auto& [a, b] : {std::pair{-0.2, 0.3}, std::pair{0.1, 0.4}, std::pair{-0.3, -0.1}}) {
        EXPECT_NEAR(joined(a, b, "union", 0, "distance"), std::min(a, b), 1e-6);
        EXPECT_NEAR(joined(a, b, "intersection", 0, "distance"), std::max(a, b), 1e-6);
        EXPECT_NEAR(joined(a, b, "subtraction", 0, "distance"), std::max(a, -b), 1e-6);
        EXPECT_NEAR(joined(a, b, "exclusion", 0, "distance"),
                    std::max(std::min(a, b), -std::max(a, b)), 1e-6);
    }
    EXPECT_NEAR(joined(0.1, 0.1, "union", 0.2, "distance"), 0.05, 1e-6);
    EXPECT_NEAR(joined(0.1, 0.1, "intersection", 0.2, "distance"), 0.15, 1e-6);
    EXPECT_NEAR(joined(0.1, 0.1, "union", 0.2, "share"), 0.5, 1e-6);
    EXPECT_NEAR(joined(0.1, 0.2, "union", 0.2, "share"), 0.25, 1e-6);
    EXPECT_NEAR(joined(0.2, 0.1, "union", 0.2, "share"), 0.75, 1e-6);
    EXPECT_NEAR(joined(0.5, 0.1, "union", 0.2, "share"), 1, 1e-6);
}

// For a and b at right angles, as x and y: the cut is a line at 45 degrees, a band from the corner.
TEST(ShapeCombine, CutsAChamfer) {
    const auto cut = [](double x, double y, const char* mode, const char* output = "distance") {
        return joined(x, y, mode, 0.2, output, "chamfer");
    };
    EXPECT_NEAR(cut(0.2, 0, "union"), 0, 1e-6);
    EXPECT_NEAR(cut(0, 0.2, "union"), 0, 1e-6);
    EXPECT_NEAR(cut(0.13, 0.07, "union"), 0, 1e-6);
    EXPECT_NEAR(cut(0.15, 0.15, "union"), 0.1 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(cut(0.5, 0.1, "union"), 0.1, 1e-6);
    EXPECT_NEAR(cut(-0.1, -0.1, "intersection"), 0, 1e-6);
    EXPECT_NEAR(cut(-0.5, -0.1, "intersection"), -0.1, 1e-6);
    EXPECT_NEAR(cut(-0.1, 0.1, "subtraction"), 0, 1e-6);
    EXPECT_NEAR(cut(0.1, 0.1, "union", "share"), 0.5, 1e-6);
    EXPECT_NEAR(cut(0.2, 0, "union", "share"), 1, 1e-6);
    EXPECT_NEAR(joined(0.1, 0.3, "union", 0, "distance", "chamfer"), 0.1, 1e-6);
}

// By differences: the slopes along a and b are the parts of both, and add up to 1.
TEST(ShapeCombine, SharesAreItsSlopes) {
    for (const char* seam : {"quadratic", "cubic"})
        for (const double b : {0.02, 0.1, 0.15, 0.18, 0.29, 0.4}) {
            const auto at = [&](double a, double c) {
                return joined(a, c, "union", 0.2, "distance", seam);
            };
            const double step = 1e-3, by_a = (at(0.1 + step, b) - at(0.1 - step, b)) / (2 * step);
            const double by_b = (at(0.1, b + step) - at(0.1, b - step)) / (2 * step);
            EXPECT_NEAR(joined(0.1, b, "union", 0.2, "share", seam), by_b, 3e-3) << seam << b;
            EXPECT_NEAR(by_a + by_b, 1, 1e-3) << seam << b;
        }
    EXPECT_NEAR(joined(0.1, 0.1, "union", 0.2, "distance", "cubic"), 0.1 - 0.2 / 6, 1e-6);
}

double through_distance(const std::string& type, const std::string& in, double distance,
                        const std::string& output = "value", double width = 0) {
    return numbers_through(type, "distance", in, output, {distance}, width)[0];
}

TEST(ShapeFill, IsTheCoveredPartOfAPixel) {
    for (const double d : {-0.3, -0.06, 0.0, 0.02, 0.09, 0.3}) {
        const double mean = box_mean([](double x) { return x < 0 ? 1.0 : 0.0; }, d, 0.2);
        EXPECT_NEAR(through_distance("shape_fill", "", d, "value", 0.2), mean, 1e-3);
    }
    EXPECT_NEAR(through_distance("shape_fill", "\"softness\": 0.4", 0.1), 0.25, 1e-6);
    EXPECT_EQ(through_distance("shape_fill", "\"width\": 0.1", 0.04, "outline"), 1);
    EXPECT_EQ(through_distance("shape_fill", "\"width\": 0.1", -0.06, "outline"), 0);
}

TEST(ShapeOnion, GrowsAndOutlines) {
    EXPECT_NEAR(through_distance("shape_onion", "\"grow\": 0.1", 0.3, "distance"), 0.2, 1e-6);
    EXPECT_NEAR(through_distance("shape_onion", "\"line\": true", -0.3, "distance"), 0.29, 1e-6);
    EXPECT_NEAR(through_distance("shape_onion", R"("grow": 0.1, "invert": true)", 0.3, "distance"),
                -0.2, 1e-6);
}

TEST(Bevel, HasItsProfile) {
    const auto at = [](const char* profile, double t) {
        return through_distance("bevel",
                                std::string("\"width\": 1, \"profile\": \"") + profile + "\"", -t);
    };
    for (const char* profile : {"linear", "smooth", "round", "cove"}) {
        EXPECT_NEAR(at(profile, -0.5), 0, 1e-6) << profile;
        EXPECT_NEAR(at(profile, 1.5), 1, 1e-6) << profile;
    }
    EXPECT_NEAR(at("linear", 0.3), 0.3, 1e-6);
    EXPECT_NEAR(at("smooth", 0.25), 0.15625, 1e-6);
    EXPECT_NEAR(at("round", 0.5), std::sqrt(0.75), 0.015);  // a quarter circle, almost
    EXPECT_NEAR(at("cove", 0.5), 1 - std::sqrt(0.75), 0.015);
    EXPECT_NEAR(
        through_distance("bevel", "\"profile\": \"linear\", \"width\": 0", -0.1, "value", 0.2), 0.5,
        1e-6);
}

}  // namespace
}  // namespace wrinkle::test
