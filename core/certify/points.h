// Surface points for the comparison of back ends, with every input and differential given.
// random_points() and degenerate_points() contain only values that are exact in float, so that
// float, double and GPU have equal inputs.
#pragma once

#include <string_view>

#include "cpu/evaluate.h"

namespace wrinkle::certify {

// Points typical of a renderer: curved, with uvs of any orientation, tangents orthogonal to the
// normal and not unit, interpolated normals of length 0.85 to 1, both sides.
struct UvRange {
    double low = -1.5;
    double high = 2.5;
};
PointSet random_points(size_t count, unsigned seed, UvRange uvs = {});

// Zero differentials of the uvs, of the position, of all of them and the normal; zero tangent;
// tangent w = 0; zero view vector; everything zero except the normal (facing 1); positions and uvs
// times 1e3; differentials of positions and uvs times 1e-6.
PointSet degenerate_points();
// Describes one of these points: "the tangent is zero".
std::string_view degenerate_words(size_t point);

// Returns every number moved up or down by 4 float ulp, except signs (facing, tangent w).
PointSet nudged(const PointSet& points, unsigned seed);

// Returns every input moved by `step` pixels in x, along its differential.
PointSet moved_in_x(const PointSet& points, double step);

}  // namespace wrinkle::certify
