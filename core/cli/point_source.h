// The points of an eval, in blocks: from JSON, from a table, or places of a mesh with the surface
// there. Memory is bounded by the table and one block.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/point_table.h"
#include "cli/points.h"
#include "cli/session.h"

namespace wrinkle::cli {

struct PointSource {
    size_t count = 0;
    // Reports what is needed and no point has; true when nothing is.
    std::function<bool(const std::vector<InputNeed>& needs, Diagnostics& diagnostics)> check;
    // Writes the needed values of the points first ... first + set.count - 1; false with errors.
    std::function<bool(const std::vector<InputNeed>& needs, size_t first, PointSet& set,
                       Diagnostics& diagnostics)>
        fill;
    // A problem at a point.
    std::function<void(size_t point, Severity severity, std::string message, std::string expected,
                       Diagnostics& diagnostics)>
        report;
};

// `points` outlives the source.
PointSource source_of(const std::vector<Point>& points);

// The options that choose points: --at, or --mesh with --at or --uv.
struct PointOptions {
    std::string at;        // JSON, "@FILE", "FILE.csv", "FILE.npy", "-"; points, or places as uv0
    std::string mesh;      // "" or as cli/meshes.h takes it
    std::string uv;        // one place, "U,V"
    uint32_t size = 1024;  // dx and dy are one texel of a size * size layout
};
bool is_uv(const std::string& text);

// With errors reported, a source without points.
PointSource open_points(const PointOptions& options, const CommonOptions& common,
                        Diagnostics& diagnostics);

}  // namespace wrinkle::cli
