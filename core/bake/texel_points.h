// The surface points of covered texels, as the planes that a program reads.
//
// A point is what sample_mesh() (mesh/sample.h) gives there, to the last bit, its dx and dy one
// texel of the layout, as floats; a place outside of its triangle by the raster's rounding has what
// stands on its border, but for uv0, which is the place itself. A bake looks at the outside from
// straight above: `facing` is 1 and `view` the normal made unit.
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

// What the program needs and the mesh lacks, such as "uv1"; "" for nothing.
std::string missing_input(const Mesh& mesh, const Program& program);

// What one thread keeps of the triangles that it met last: a row of texels meets the same ones as
// the row below.
struct MetTriangles {
    struct Met {
        uint32_t triangle = Coverage::none;
        UvTriangle uv;
        TrianglePlanes planes;  // in the vectors below
        std::vector<LinearPlane> linear;
        std::vector<ConstantPlane> constant;
    };
    std::array<Met, 64> met;  // by the lowest bits of a triangle's number
};

class TexelPoints {
public:
    // Nothing is missing. All three stay as they are.
    TexelPoints(const Mesh& mesh, const Program& program, const UvLayout& layout);

    // Points in the order of `coverage`: the owned texels, then the samples.
    static size_t count(const Coverage& coverage);

    // Plane i, by index of Program::inputs, begins at planes + i * stride. Behind its last point as
    // many numbers as `interpolated_behind` are written over. `met` is kept for this object alone.
    // Planes that hold one number in the whole bake stay as fill_constants() left them.
    void fill_constants(size_t stride, float* planes) const;
    void fill(const Coverage& coverage, const TexelRect& rect, size_t stride, float* planes,
              MetTriangles& met) const;

private:
    // Of one input: its number at vertex i stands at values[i * stride].
    struct Source {
        size_t plane;
        Variant variant;
        uint32_t lane;
        const float* values = nullptr;
        uint32_t stride = 0;
    };

    void add(const Program::Input& input, size_t plane);
    glm::dvec3 change(const UvTriangle& triangle, Variant variant) const;
    void learn(uint32_t triangle, MetTriangles::Met& one) const;
    // Points side by side; what follows them.
    float* fill_row(std::span<const uint32_t> owners, const double* u, double v, size_t stride,
                    float* out, MetTriangles& met) const;
    void fill_places(const PlaceRow& row, size_t stride, float* out) const;
    void fill_view(const MetTriangles::Met& one, const PlaceRow& row, const Source& source,
                   float* out) const;

    const Mesh& mesh_;
    UvLayout layout_;
    // Inputs by what they are over a triangle; `constants_` are so over the layout.
    std::vector<Source> linear_, changes_, places_, views_;
    std::vector<ConstantPlane> constants_;
    std::vector<double> columns_;  // u of the texels' centres
    Interpolate interpolate_;
};

}  // namespace wrinkle
