#include "nodes/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "nodes/plane.h"

namespace wrinkle::test {

std::vector<Point2> random_places(size_t count) {
    std::mt19937 random(31);
    std::vector<Point2> places(count);
    for (Point2& p : places)
        for (double& each : p)
            each = random() / 4294967296.0;
    return places;
}

double to_outline(const std::vector<Point2>& outline, Point2 p) {
    double nearest = 9, winding = 0;
    for (size_t k = 0; k < outline.size(); ++k) {
        const Point2 a = outline[k], b = outline[(k + 1) % outline.size()];
        const double ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
        const double dx = b[0] - a[0], dy = b[1] - a[1];
        const double t = std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(ax + t * dx, ay + t * dy));
        winding += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return std::fabs(winding) > half_turn ? -nearest : nearest;
}

void add_arc(std::vector<Point2>& outline, Point2 center, double radius, double from, double turn) {
    for (int k = 0; k <= 400; ++k) {
        const double angle = from + turn * k / 400;
        outline.push_back(
            {center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle)});
    }
}

void expect_outline(const std::string& type, const std::string& in,
                    const std::vector<Point2>& outline) {
    const auto places = random_places(400);
    const auto got = values({one(type, in), "n.distance"}, places);
    for (size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(got[i][0], to_outline(outline, places[i]), 1e-4)
            << type << " at " << places[i][0] << " " << places[i][1];
}

void expect_slope_of_one(const std::string& type) {
    const std::string nodes =
        one(type) +
        R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.distance"}}})";
    for (const auto& g : values({nodes, "g.gradient"}, random_places(300)))
        EXPECT_NEAR(std::hypot(g[0], g[1]), 1, 1e-5) << type;
}

}  // namespace wrinkle::test
