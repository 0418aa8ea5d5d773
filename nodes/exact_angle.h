// The angle of a vector, more exact than atan() of GLSL, which may be off by 1e-4: patterns around
// a point multiply the angle, and with it the error.
#pragma once

#include "nodes/constants.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {

// Returns the angle anticlockwise from x, -pi to pi, within 3e-7; 0 for the zero vector. Its slope
// is exact. Polynomial: Abramowitz and Stegun, 4.4.49, within 2e-8.
inline sdk::Float exact_angle(sdk::vec2 p) {
    using namespace sdk;
    const auto angle = function("exact_angle(p)", [](vec2 p) {
        constexpr double factors[] = {-0.0161657367, 0.0429096138, -0.0752896400, 0.1065626393,
                                      -0.1420889944, 0.1999355085, -0.3333314528, 1};
        const vec2 side = named("side", abs(p));
        const Float longer = named("longer", max(side.x(), side.y()));
        const Float t = named("t", divide(min(side.x(), side.y()), longer));
        const Float square = named("square", t * t);
        Float sum = 0.0028662257;
        for (const double factor : factors)
            sum = sum * square + factor;
        const Float octant = named("octant", t * sum);
        const Float quarter =
            named("quarter", select(side.y() > side.x(), 0.5 * pi() - octant, octant));
        const Float half = named("half_turn", select(p.x() < 0, pi() - quarter, quarter));
        return select(p.y() < 0, -half, half);
    });
    const vec2 here = named("here", detach(p));
    const Float square = max(dot(here, here), min_area());
    return with_slope(angle(here), p, vec2(-here.y(), here.x()) / square);
}

}  // namespace wrinkle::nodes
