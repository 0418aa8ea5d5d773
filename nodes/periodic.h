// Exact means of functions over a box, and functions that repeat, for waves and gradients.
//
// A function is given as vec2(integral, value) at x. Its mean over a box around x is a difference
// of integrals, and the derivative of the mean is the difference of values over the width. A width
// counts at least as 1/512, where the difference still has a precision of 1e-4: walls are 1/512
// wide close up, and no width divides by 0.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

// The distance to the nearest odd number: a triangle wave of period 2 between 0 and 1, the
// integral of a square wave between -1 and 1.
template <class V>
V triangle(V x) {
    using namespace sdk;
    const V turn = named("turn", x * 0.5);
    return abs(named("wave", (turn - floor(turn)) * 2 - 1));
}

template <class F>
sdk::Float box_mean(F function, sdk::Float x, sdk::Float width) {
    using namespace sdk;
    const Float box = named("box", max(width, named("min_box // least width", Float(1.0 / 512))));
    const vec2 low = named("low", function(x - 0.5 * box));
    const vec2 high = named("high", function(x + 0.5 * box));
    const vec2 mean = named("mean", (high - low) / box);
    return detach(mean.x()) + detach(mean.y()) * (x - detach(x));
}

// The mean of a function of period 1. Complete periods are left out, so that large numbers lose no
// digits.
template <class F>
sdk::Float periodic_mean(F function, sdk::Float x, sdk::Float width) {
    return box_mean(function, named("turned", x - floor(x)), width);
}

}  // namespace wrinkle::nodes
