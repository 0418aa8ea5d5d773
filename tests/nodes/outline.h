// Outlines of shapes as many points, and the distance to them by brute force.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace wrinkle::test {

using Point2 = std::array<double, 2>;
inline constexpr double half_turn = 3.141592653589793;

// Points of the unit square, the same in each run.
std::vector<Point2> random_places(size_t count);

// Distance to a closed outline of straight parts, negative inside, by the winding number.
double to_outline(const std::vector<Point2>& outline, Point2 p);

// Points of an outline around (0.5, 0.5), from a radius by the angle clockwise from up.
template <class Radius>
std::vector<Point2> polar(int count, Radius radius) {
    std::vector<Point2> outline;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * half_turn * k / count, r = radius(k);
        outline.push_back({0.5 + r * std::sin(angle), 0.5 + r * std::cos(angle)});
    }
    return outline;
}
// Adds an arc: centre, radius, first angle and angle turned, anticlockwise from x.
void add_arc(std::vector<Point2>& outline, Point2 center, double radius, double from, double turn);

// The distance of the node differs from the outline's by less than 1e-4 at many points.
void expect_outline(const std::string& type, const std::string& in,
                    const std::vector<Point2>& outline);

// The slope of the distance has length 1 at many points.
void expect_slope_of_one(const std::string& type);

}  // namespace wrinkle::test
