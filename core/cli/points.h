// Surface points as columns of numbers, read from JSON or from a table: a CSV file with a header
// line, or an NPY file (cli/npy.h).
//
//   {"normal": [x, y, z], "uv0": [u, v], "facing": 1, "dx": {"uv0": [0.001, 0]}, "dy": {...}}
//   normal.x,normal.y,normal.z,uv0.x,uv0.y,facing,dx.uv0.x,dx.uv0.y
//
// dx and dy hold the differentials to the next pixel. Only `facing` has a default (+1). Numbers are
// finite and no normal is zero. Errors name the JSON value, or the file, line (CSV) and point.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "cpu/columns.h"
#include "json/value.h"

namespace wrinkle::cli {

using Needs = std::vector<InputNeed>;

struct PointList {
    PointSet given;                    // NaN: the point lacks the value; empty: all points do
    std::string file;                  // table, for messages; "": from JSON
    uint32_t first_line = 0;           // CSV: line of the first point
    bool numbered = true;              // messages have the number of the point
    std::vector<json::Value> sources;  // JSON: values of the points

    size_t count() const { return given.count; }
    // Reports needed values that the points lack; returns true if there are none.
    bool check(const Needs& needs, Diagnostics& diagnostics) const;
    // Reports a problem at a point.
    void report(size_t point, RuleId rule, Severity severity, std::string message,
                std::string expected, Diagnostics& diagnostics) const;
    // Stores one number. O(1) amortized.
    void set(const InputNeed& need, size_t point, size_t lane, double value);
    // Completes the columns after the last point.
    void finish();
};

std::string lacks(const std::string& owner, const InputNeed& need);  // "the table lacks 'uv0'"

// Returns the name of one column: "uv0.x", "dx.normal.z", "facing".
std::string column_name(const std::string& value, size_t lane, size_t lanes);

// Reads one point or an array of points.
PointList read_points(const json::Value& value, Diagnostics& diagnostics);

// Reads a table; `file` ends with .csv or .npy. Columns may have any order; an input needs all its
// components. Returns no points after an error.
PointList read_table(const std::string& file, std::string_view bytes, Diagnostics& diagnostics);

// Reads the value of --at: JSON text, "@FILE", "-" for standard input, or the name of a table.
PointList open_list(const std::string& at, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
