// Tests of shapes with corners and arcs against outlines made of many points.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/number.h"
#include "nodes/outline.h"

namespace wrinkle::test {
namespace {

TEST(Figure, TriangleIsAsFarAsItsOutline) {
    expect_outline("sd_triangle", "", {{0.2, 0.25}, {0.8, 0.25}, {0.5, 0.8}});
    expect_outline("sd_triangle", R"("a": [0.1, 0.9], "b": [0.7, 0.6], "c": [0.2, 0.2])",
                   {{0.1, 0.9}, {0.7, 0.6}, {0.2, 0.2}});
}

TEST(Figure, RhombusIsAsFarAsItsOutline) {
    expect_outline("sd_rhombus", "", {{0.75, 0.5}, {0.5, 0.85}, {0.25, 0.5}, {0.5, 0.15}});
    expect_outline("sd_rhombus", R"("size": [0.8, 0.2], "center": [0.4, 0.6])",
                   {{0.8, 0.6}, {0.4, 0.7}, {0, 0.6}, {0.4, 0.5}});
}

TEST(Figure, TrapezoidIsAsFarAsItsOutline) {
    expect_outline("sd_trapezoid", "", {{0.15, 0.25}, {0.85, 0.25}, {0.7, 0.75}, {0.3, 0.75}});
    expect_outline("sd_trapezoid", R"("bottom": 0.1, "top": 0.9, "height": 0.2, "rotation": 90)",
                   {{0.6, 0.45}, {0.6, 0.55}, {0.4, 0.95}, {0.4, 0.05}});
    expect_outline("sd_trapezoid", R"("top": 0)", {{0.15, 0.25}, {0.85, 0.25}, {0.5, 0.75}});
}

TEST(Figure, PieIsAsFarAsItsOutline) {
    for (const double degrees : {40.0, 120.0, 180.0, 300.0}) {
        const double turn = degrees * half_turn / 180;
        std::vector<Point2> pie{{0.5, 0.5}};
        add_arc(pie, {0.5, 0.5}, 0.4, half_turn / 2 - turn / 2, turn);
        expect_outline("sd_pie", "\"angle\": " + std::to_string(degrees), pie);
    }
}

// The circles cross at the angles of the cosine law, from both centres.
TEST(Figure, MoonIsAsFarAsItsOutline) {
    const auto moon = [](double radius, double cut, double offset) {
        const double a =
            std::acos((radius * radius + offset * offset - cut * cut) / (2 * radius * offset));
        const double b =
            std::acos((cut * cut + offset * offset - radius * radius) / (2 * cut * offset));
        std::vector<Point2> outline;
        add_arc(outline, {0.5, 0.5}, radius, a, 2 * half_turn - 2 * a);
        add_arc(outline, {0.5 + offset, 0.5}, cut, half_turn + b, -2 * b);
        return outline;
    };
    expect_outline("sd_moon", "", moon(0.4, 0.35, 0.2));
    expect_outline("sd_moon", R"("radius": 0.3, "cut": 0.1, "offset": 0.28)", moon(0.3, 0.1, 0.28));
    std::vector<Point2> turned = moon(0.3, 0.4, 0.2);
    for (Point2& p : turned)
        p[0] = 1 - p[0];
    expect_outline("sd_moon", R"("radius": 0.3, "cut": 0.4, "offset": -0.2)", turned);
}

// A hole within the disc, no cut at all, and nothing left.
TEST(Figure, MoonOfCirclesThatDoNotCross) {
    const auto at = [](const char* in, double x) {
        return value({one("sd_moon", in), "n.distance"}, x, 0.5)[0];
    };
    const char* hole = R"("radius": 0.4, "cut": 0.1, "offset": 0.1)";
    EXPECT_NEAR(at(hole, 0.58), 0.08, 1e-6);
    EXPECT_NEAR(at(hole, 0.75), -0.05, 1e-6);
    EXPECT_NEAR(at(hole, 0.97), 0.07, 1e-6);
    EXPECT_NEAR(at(R"("radius": 0.4, "cut": 0.1, "offset": 0)", 0.55), 0.05, 1e-6);
    EXPECT_NEAR(at(R"("radius": 0.2, "cut": 0.1, "offset": 0.5)", 0.6), -0.1, 1e-6);
    for (const double x : {0.1, 0.5, 0.9})
        EXPECT_GT(at(R"("radius": 0.2, "cut": 0.4, "offset": 0.1)", x), 0) << x;
}

// Two arcs through the tips: the sagitta is half of the width.
TEST(Figure, VesicaIsAsFarAsItsOutline) {
    const double radius = (0.4 * 0.4 + 0.2 * 0.2) / (2 * 0.2), half = std::asin(0.4 / radius);
    std::vector<Point2> lens;
    add_arc(lens, {0.5 + 0.2 - radius, 0.5}, radius, -half, 2 * half);
    add_arc(lens, {0.5 - 0.2 + radius, 0.5}, radius, half_turn - half, 2 * half);
    expect_outline("sd_vesica", "", lens);
    for (Point2& p : lens)
        std::swap(p[0], p[1]);
    expect_outline("sd_vesica", R"("size": [0.8, 0.4])", lens);
    std::vector<Point2> circle;
    add_arc(circle, {0.5, 0.5}, 0.3, 0, 2 * half_turn);
    expect_outline("sd_vesica", R"("size": [0.6, 0.6])", circle);
}

// A square on its corner with a half circle on each of the two upper sides.
TEST(Figure, HeartIsAsFarAsItsOutline) {
    const double size = 0.8, scale = size / (0.75 + std::sqrt(0.125)), radius = std::sqrt(0.125);
    std::vector<Point2> heart{{0, 0}};
    add_arc(heart, {0.25, 0.75}, radius, -half_turn / 4, half_turn);
    add_arc(heart, {-0.25, 0.75}, radius, half_turn / 4, half_turn);
    for (Point2& p : heart)
        p = {0.5 + p[0] * scale, 0.5 - size / 2 + p[1] * scale};
    expect_outline("sd_heart", "", heart);
}

TEST(Figure, CrossIsAsFarAsItsOutline) {
    std::vector<Point2> cross;
    for (const auto& [x, y] : {std::pair{0.1, 0.1},
                               {0.1, 0.35},
                               {-0.1, 0.35},
                               {-0.1, 0.1},
                               {-0.35, 0.1},
                               {-0.35, -0.1},
                               {-0.1, -0.1},
                               {-0.1, -0.35},
                               {0.1, -0.35},
                               {0.1, -0.1},
                               {0.35, -0.1},
                               {0.35, 0.1}})
        cross.push_back({0.5 + x, 0.5 + y});
    expect_outline("sd_cross", "", cross);
    expect_outline("sd_cross", R"("length": 0.4, "width": 1)",
                   {{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}});
}

// Distances to a point, of the least sizes that are allowed: no point of the plane is inside.
TEST(Figure, OfNoSizeHasNoInside) {
    const std::pair<const char*, const char*> figures[] = {
        {"sd_circle", R"("radius": 0)"},
        {"sd_ring", R"("radius": 0, "width": 0)"},
        {"sd_box", R"("size": [0, 0])"},
        {"sd_segment", R"("a": [0.5, 0.5], "b": [0.5, 0.5], "radius": 0)"},
        {"sd_polygon", R"("radius": 0)"},
        {"sd_star", R"("radius": 0)"},
        {"sd_arc", R"("radius": 0, "width": 0)"},
        {"sd_ellipse", R"("size": [0.001, 0.001])"},
        {"sd_triangle", R"("a": [0.5, 0.5], "b": [0.5, 0.5], "c": [0.5, 0.5])"},
        {"sd_rhombus", R"("size": [0.001, 0.001])"},
        {"sd_trapezoid", R"("bottom": 0, "top": 0, "height": 0.001)"},
        {"sd_pie", R"("radius": 0)"},
        {"sd_moon", R"("radius": 0, "cut": 0, "offset": 0)"},
        {"sd_vesica", R"("size": [0.001, 0.001])"},
        {"sd_heart", R"("size": 0.001)"},
        {"sd_cross", R"("length": 0, "width": 0)"}};
    const auto places = random_places(50);
    for (const auto& [type, in] : figures) {
        const auto got = values({one(type, in), "n.distance"}, places);
        for (size_t i = 0; i < places.size(); ++i)
            EXPECT_NEAR(got[i][0], std::hypot(places[i][0] - 0.5, places[i][1] - 0.5), 2e-3)
                << type;
    }
}

TEST(Figure, HasASlopeOfOne) {
    for (const char* type : {"sd_triangle", "sd_rhombus", "sd_trapezoid", "sd_pie", "sd_moon",
                             "sd_vesica", "sd_heart", "sd_cross"})
        expect_slope_of_one(type);
}

}  // namespace
}  // namespace wrinkle::test
