// Surface points in JSON.
//
//   {"position": [x, y, z], "normal": [...], "uv0": [u, v], ..., "facing": 1,
//    "dx": {"position": [...], "uv0": [...], ...}, "dy": {...}}
//
// dx and dy hold the differentials to the next pixel. Only `facing` has a default (+1); a value
// that a material needs and a point lacks is an error that names it. Numbers are finite.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "cpu/columns.h"
#include "json/value.h"

namespace wrinkle::cli {

struct Point {
    struct Slot {
        bool given = false;
        std::array<double, 4> lanes{};
    };
    std::array<Slot, PointSet::inputs * 3> slots;
    std::string name;    // "point 3", for messages
    json::Value source;  // value that the point was read from

    Slot& operator[](const InputNeed& input) { return slots[index(input)]; }
    const Slot& operator[](const InputNeed& input) const { return slots[index(input)]; }

private:
    static size_t index(const InputNeed& input) {
        return static_cast<size_t>(input.input) * 3 + static_cast<size_t>(input.variant);
    }
};

// Reads one point or an array of points.
std::vector<Point> read_points(const json::Value& value, Diagnostics& diagnostics);

// Reads the value of --at: JSON text, "@FILE", or "-" for standard input.
std::vector<Point> points_of_option(const std::string& at, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
