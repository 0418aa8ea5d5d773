// Points of an evaluation in blocks: from JSON, from a table, or surface points of a mesh at given
// uvs. Memory is bounded by the input points and one block.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/point_table.h"
#include "cli/points.h"
#include "cli/session.h"

namespace wrinkle::cli {

using Needs = std::vector<InputNeed>;

struct PointSource {
    size_t count = 0;
    // Reports needed values that the points lack; returns true if there are none.
    std::function<bool(const Needs& needs, Diagnostics& diagnostics)> check;
    // Writes the needed values of points [first, first + set.count); returns false and reports
    // errors on failure.
    std::function<bool(const Needs& needs, size_t first, PointSet& set, Diagnostics& diagnostics)>
        fill;
    // Reports a problem at a point.
    std::function<void(size_t point, Severity severity, std::string message, std::string expected,
                       Diagnostics& diagnostics)>
        report;
};

PointSource source_of(std::vector<Point> points);

// Options that select points: --at, or --mesh with --at or --uv.
struct PointOptions {
    std::string at;        // JSON, "@FILE", "FILE.csv", "FILE.npy", "-"; with --mesh, uv0 only
    std::string mesh;      // "", or a shape name or path (cli/meshes.h)
    std::string uv;        // one uv, "U,V"
    uint32_t size = 1024;  // dx and dy span one texel of a size x size layout
};
bool is_uv(const std::string& text);

// Returns a source without points and reports errors on failure.
PointSource open_points(const PointOptions& options, const CommonOptions& common,
                        Diagnostics& diagnostics);

}  // namespace wrinkle::cli
