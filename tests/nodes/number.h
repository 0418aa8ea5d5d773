// Evaluates a node of one varying number, at any footprint of that number.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "nodes/plane.h"

namespace wrinkle::test {

// The output "n.<output>" where the input `port` is each of these numbers, changing by `width` to
// the next pixel in x; `in` has further members.
inline std::vector<std::vector<double>> through(const std::string& type, const std::string& port,
                                                const std::string& in, const std::string& output,
                                                const std::vector<double>& numbers,
                                                double width = 0) {
    const double scale = width > 0 ? width / pixel : 1;
    std::vector<std::array<double, 2>> points;
    for (const double number : numbers)
        points.push_back({number / scale, 0.5});
    const std::string wire = "\"" + port + "\": {\"from\": \"s." + (width > 0 ? "x" : "y") + "\"}";
    const std::string nodes =
        one(type, wire + (in.empty() ? "" : ", " + in)) +
        R"(, "t": {"type": "uv_transform", "in": {"scale": [)" + std::to_string(scale) +
        R"(, 1]}}, "s": {"type": "separate_vec2", "in": {"vector": {"from": "t.uv"}}})";
    if (width > 0) return values({nodes, "n." + output}, points);
    // No footprint: every differential is zero.
    Scene scene{nodes, "n." + output};
    for (auto& [x, y] : points)
        std::swap(x, y);
    PointSet set = plane_points(scene, points);
    for (auto& input : set.values)
        for (const Variant variant : {Variant::dx, Variant::dy})
            for (double& each : input[static_cast<size_t>(variant)])
                each = 0;
    return values(scene, set);
}

inline std::vector<double> numbers_through(const std::string& type, const std::string& port,
                                           const std::string& in, const std::string& output,
                                           const std::vector<double>& numbers, double width = 0) {
    std::vector<double> first;
    for (const auto& lanes : through(type, port, in, output, numbers, width))
        first.push_back(lanes[0]);
    return first;
}

// The mean over a box of `width` around x of an unfiltered function, by samples.
template <class F>
double box_mean(F f, double x, double width, int samples = 4096) {
    double sum = 0;
    for (int k = 0; k < samples; ++k)
        sum += f(x + ((k + 0.5) / samples - 0.5) * width);
    return sum / samples;
}

}  // namespace wrinkle::test
