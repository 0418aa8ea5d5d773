// Evaluates procedural heights: values in coordinates of cells, at any footprint.
#pragma once

#include <cmath>
#include <random>

#include "nodes/plane.h"

namespace wrinkle::test {

using Point = std::array<double, 2>;

// Name of the pattern's density input.
inline std::string density_of(const std::string& type) {
    return type == "pyramids" ? "density" : "scale";
}

struct Reading {
    std::vector<double> value;
    std::vector<Point> slope;  // dvalue / dcell
};

// Evaluates the node at points given in cells, with pixels `footprint` cells wide; `in` has further
// members.
inline Reading read(const std::string& type, const std::string& in, std::vector<Point> cells,
                    double footprint = 1e-4) {
    const double scale = footprint / pixel;
    for (Point& p : cells)
        p = {p[0] / scale, p[1] / scale};
    const std::string members = "\"" + density_of(type) + "\": " + std::to_string(scale) +
                                ", \"amplitude\": 1" + (in.empty() ? "" : ", " + in);
    const std::string nodes =
        one(type, members) +
        R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.height"}}})";
    Reading reading;
    for (const auto& lanes : values({nodes, "n.value"}, cells))
        reading.value.push_back(lanes[0]);
    for (const auto& lanes : values({nodes, "g.gradient"}, cells))
        reading.slope.push_back({lanes[0] / scale, lanes[1] / scale});
    return reading;
}

inline std::vector<double> value_of(const std::string& type, const std::string& in,
                                    const std::vector<Point>& cells, double footprint = 1e-4) {
    return read(type, in, cells, footprint).value;
}

inline std::vector<Point> random_cells(size_t count, double size, unsigned seed = 1) {
    std::mt19937 random(seed);
    const auto number = [&] { return (random() / 4294967296.0 - 0.5) * size; };
    std::vector<Point> points(count);
    for (Point& p : points) {
        p[0] = number();
        p[1] = number();
    }
    return points;
}

// The functions documented in sdk/math.h: the PCG permutation, and its upper 24 bits.
inline uint32_t pcg(uint32_t x) {
    const uint32_t state = x * 747796405U + 2891336453U;
    const uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737U;
    return (word >> 22) ^ word;
}
inline uint32_t pcg(int x, int y, int z) {
    return pcg(static_cast<uint32_t>(x) +
               pcg(static_cast<uint32_t>(y) + pcg(static_cast<uint32_t>(z))));
}
inline double unit_number(uint32_t bits) {
    return (bits >> 8) / 16777216.0;
}

// Ids of all procedural height nodes.
inline std::vector<std::string> procedural_nodes() {
    std::vector<std::string> ids;
    for (const NodeType& type : registry().list()) {
        bool value = false, height = false, amplitude = false;
        for (const wrinkle::Port& port : type.ports) {
            value |= port.name == "value" && port.kind == wrinkle::Port::Kind::output;
            height |= port.name == "height" && port.kind == wrinkle::Port::Kind::output;
            amplitude |= port.name == "amplitude";
        }
        const bool pattern = type.family == "noise" || type.family == "pattern";
        if (pattern && value && height && amplitude) ids.push_back(type.id);
    }
    return ids;
}

}  // namespace wrinkle::test
