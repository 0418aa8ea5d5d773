// Surface points given as numbers: read from JSON, or taken from a mesh.
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
    json::Value source;  // where it was read; null when it comes from a mesh

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

// "U,V" on a mesh as cli/meshes.h takes it, dx and dy one texel of a size * size layout.
struct MeshPlace {
    std::string mesh;
    std::string uv;
    uint32_t size = 1024;
};
bool is_uv(const std::string& text);
std::vector<Point> points_on_mesh(const MeshPlace& place, const CommonOptions& options,
                                  Diagnostics& diagnostics);

// Reports what is needed and absent; true when nothing is.
bool all_given(const std::vector<Point>& points, const Program& program, Diagnostics& diagnostics);

// The same as arrays of what the program reads; all is given.
PointSet point_set(const std::vector<Point>& points, const Program& program);

}  // namespace wrinkle::cli
