// The surface points of covered texels, as the input planes of a program.
//
// A point has the attributes that sample_mesh() (mesh/sample.h) returns there, bit by bit, rounded
// to float; its dx and dy are per texel of the layout. A point outside its triangle, because the
// raster rounds corners, takes the attributes at the triangle's border, but its own uv as uv0. A
// bake views the surface from outside along the normal: `facing` is 1, and `view` is the normalised
// normal.
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

    // Plane i, by index of Program::inputs, begins at planes + i * stride. fill() overwrites up to
    // `interpolate_padding` numbers after the last point of a plane. `cache` must be used with this
    // object only. fill() does not write planes that are constant over the bake; fill_constants()
    // does.
    void fill_constants(size_t stride, float* planes) const;
    void fill(const Coverage& coverage, const TexelRect& rect, size_t stride, float* planes,
              TriangleCache& cache) const;

private:
    // One input; its value at vertex i is values[i * stride].
    struct Source {
        size_t plane;
        Variant variant;
        uint32_t lane;
        const float* values = nullptr;
        uint32_t stride = 0;
    };

    void add(const Program::Input& input, size_t plane);
    glm::dvec3 change(const UvTriangle& triangle, Variant variant) const;
    void insert(uint32_t triangle, CachedTriangle& one) const;
    // Fills the points of adjacent texels; returns the output position after them.
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
