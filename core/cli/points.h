// Surface points given as JSON.
//
//   {"position": [x, y, z], "normal": [...], "uv0": [u, v], ..., "facing": 1,
//    "dx": {"position": [...], "uv0": [...], ...}, "dy": {...}}
//
// dx and dy hold the change of a value to the next pixel. Nothing but `facing` (+1) has a default;
// what a material needs and a point lacks is an error that names it. Numbers are finite.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "cli/session.h"
#include "cpu/columns.h"
#include "json/value.h"

namespace wrinkle::cli {

struct Point {
    struct Slot {
        bool given = false;
        std::array<double, 4> lanes{};
    };
    std::array<Slot, size_t{surface_input_count} * 3> slots;
    std::string name;    // "point 3", for messages
    json::Value source;  // where it was read

    Slot& operator[](const InputNeed& input) { return slots[index(input)]; }
    const Slot& operator[](const InputNeed& input) const { return slots[index(input)]; }

private:
    static size_t index(const InputNeed& input) {
        return static_cast<size_t>(input.input) * 3 + static_cast<size_t>(input.variant);
    }
};

// A point, or an array of them.
std::vector<Point> read_points(const json::Value& value, Diagnostics& diagnostics);

// The value of --at: JSON itself, "@FILE", or "-" for standard input.
std::vector<Point> points_of_option(const std::string& at, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
