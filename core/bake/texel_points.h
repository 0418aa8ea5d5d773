// Fills the input planes of a program with the surface points of covered texels.
//
// Attributes equal those of sample_mesh() (mesh/sample.h) bit by bit, rounded to float; dx and dy
// are per texel along +u and +v. The raster rounds corners, so a point may be outside its triangle:
// uv0 is then its own uv, and the other values are those at the clamped barycentric weights. A bake
// views the surface from outside along the normal: `facing` is 1, and `view` is the unit normal.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "cpu/evaluate.h"
#include "cpu/interpolate.h"
#include "mesh/mesh.h"
#include "mesh/uv_raster.h"
#include "mesh/uv_triangle.h"

namespace wrinkle {

// A triangle with its inputs, prepared for interpolation.
struct CachedTriangle {
    uint32_t triangle = Coverage::none;
    UvTriangle uv;
    TrianglePlanes planes;  // points into the vectors below
    std::vector<VaryingInput> linear;
    std::vector<FlatInput> constant;
};

// Per-thread cache of recently used triangles, direct-mapped by the lowest bits of the triangle
// index: a row of texels crosses mostly the same triangles as the row below.
using TriangleCache = std::array<CachedTriangle, 64>;

class TexelPoints {
public:
    // Precondition: missing_input() (bake/mesh_check.h) returns "". The mesh must outlive this
    // object and not change.
    TexelPoints(const Mesh& mesh, const Program& program, const UvLayout& layout);

    // Returns the number of points. Points are ordered as in `coverage`: owned texels, then
    // samples.
    static size_t count(const Coverage& coverage);

    // Plane i, by index of Program::inputs, begins at planes + i * stride; strides are in floats.
    // fill_constants() writes `stride` numbers to each plane that is constant over the bake. fill()
    // writes the others, and up to `interpolate_padding` numbers after the last point of a plane.
    // Thread-safe with one `cache` per thread, used with this object only.
    void fill_constants(size_t stride, float* planes) const;
    void fill(const Coverage& coverage, const TexelRect& rect, size_t stride, float* planes,
              TriangleCache& cache) const;

private:
    // One component of an input; its value at mesh vertex i is values[i * stride].
    struct Source {
        size_t plane;
        Variant variant;
        uint32_t lane;
        const float* values = nullptr;
        uint32_t stride = 0;
    };

    void add(const Program::Input& input, size_t plane);
    // Returns the change of the barycentric weights from one texel to the next.
    glm::dvec3 change(const UvTriangle& triangle, Variant variant) const;
    // Prepares the cache entry `one` for the triangle.
    void insert(uint32_t triangle, CachedTriangle& one) const;
    // Fills the covered points of one row, given u of each and their v; returns the output position
    // after them.
    float* fill_row(std::span<const uint32_t> owners, const double* u, double v, size_t stride,
                    float* out, TriangleCache& cache) const;
    void fill_uvs(const PointRow& row, size_t stride, float* out) const;
    void fill_view(const CachedTriangle& one, const PointRow& row, const Source& source,
                   float* out) const;

    const Mesh& mesh_;
    UvLayout layout_;
    // Inputs grouped by their variation over a triangle; `constants_` are constant over the layout.
    std::vector<Source> linear_, changes_, uvs_, views_;
    std::vector<FlatInput> constants_;
    std::vector<double> columns_;  // u of texel centres
    Interpolate interpolate_;
};

}  // namespace wrinkle
