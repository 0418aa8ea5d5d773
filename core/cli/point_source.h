// Points of an evaluation: given ones, or the surface points of a mesh at given uvs.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "cli/points.h"
#include "cli/session.h"
#include "mesh/mesh.h"
#include "mesh/uv_grid.h"

namespace wrinkle::cli {

struct MeshSurface {
    Mesh mesh;
    UvGrid grid;
    std::string name;
    uint32_t size = 1024;  // dx and dy span one texel of a size x size layout
};

struct PointSource {
    PointList points;
    std::optional<MeshSurface> surface = {};  // sampled at uv0 of the points

    // Reports needed values that the points lack; returns true if there are none.
    bool check(const Needs& needs, Diagnostics& diagnostics) const;
    // Writes the needed values; returns false and reports errors on failure. Precondition: check()
    // of these needs.
    bool fill(const Needs& needs, PointSet& set, Diagnostics& diagnostics) const;
};

// Options that select points: --at, or --mesh with --at or --uv.
struct PointOptions {
    std::string at;        // JSON, "@FILE", "FILE.csv", "FILE.npy", "-"; with --mesh, uv0 only
    std::string mesh;      // "", or a shape name or path (cli/meshes.h)
    std::string uv;        // one uv, "U,V"
    uint32_t size = 1024;  // dx and dy span one texel of a size x size layout
};
std::optional<glm::dvec2> parse_uv(const std::string& text);

// Returns a source without points and reports errors on failure.
PointSource open_points(const PointOptions& options, const CommonOptions& common,
                        Diagnostics& diagnostics);

}  // namespace wrinkle::cli
