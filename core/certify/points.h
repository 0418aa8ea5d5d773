// Surface points for the comparison of back ends, with every input and differential given. All
// numbers are floats, so that float, double and GPU begin with the same ones.
#pragma once

#include <string_view>

#include "cpu/evaluate.h"

namespace wrinkle::certify {

// As a renderer meets them: curved, with uvs of any orientation, tangents roughly in the surface,
// interpolated normals of lengths about 1, both sides.
struct UvRange {
    double low = -1.5;
    double high = 2.5;
};
PointSet random_points(size_t count, unsigned seed, UvRange uvs = {});

// No uv change, no position change, nothing at all, a zero tangent, w = 0, an eye in the surface;
// everything but the normal zero; large and tiny numbers.
PointSet degenerate_points();
// What is wrong with one of them: "the tangent is zero".
std::string_view degenerate_words(size_t point);

// Every number but signs moved by 4 units in the last place of a float, up or down.
PointSet nudged(const PointSet& points, unsigned seed);

// Every changing input moved by `step` pixels in x.
PointSet moved_in_x(const PointSet& points, double step);

}  // namespace wrinkle::certify
