// The surface points of covered texels, as the planes that a program reads.
//
// A point is what sample_mesh() (mesh/sample.h) gives there, to the last bit, its dx and dy one
// texel of the layout, as floats; a place outside of its triangle by the raster's rounding is
// brought back to its border. A bake looks at the outside from straight above: `facing` is 1 and
// `view` the normal made unit.
#pragma once

#include <string>
#include <vector>

#include "cpu/evaluate.h"
#include "mesh/mesh.h"
#include "mesh/uv_raster.h"

namespace wrinkle {

// What the program needs and the mesh lacks, such as "uv1"; "" for nothing.
std::string missing_input(const Mesh& mesh, const Program& program);

class TexelPoints {
public:
    // Nothing is missing. All three stay as they are.
    TexelPoints(const Mesh& mesh, const Program& program, const UvLayout& layout);

    // Points in the order of `coverage`: the owned texels, then the samples.
    static size_t count(const Coverage& coverage);

    // The planes stand behind each other in `planes`, by index of Program::inputs, `count` floats
    // each.
    void fill(const Coverage& coverage, const TexelRect& rect, size_t count, float* planes) const;

private:
    // Points of one triangle, side by side.
    struct Run {
        uint32_t triangle;
        glm::dvec2 place;  // of the first, in texels
        size_t first, count;
    };
    // Of one input: its numbers at vertex i stand at values[i * stride].
    struct Source {
        SurfaceInput input;
        Variant variant;
        const float* values;
        uint32_t stride;
        uint32_t lane;
    };

    Source source_of(const Program::Input& input) const;
    void fill_run(const Run& run, size_t count, float* planes) const;
    void fill_view(const Run& run, const Source& source, const glm::dvec3* weights,
                   const glm::dvec3& change, float* out) const;

    const Mesh& mesh_;
    UvLayout layout_;
    std::vector<Source> sources_;
};

}  // namespace wrinkle
