// The lesser of two numbers with a rounded crease, for heights, masks and distances.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

struct SmoothMinimum {
    sdk::Float value;  // never above either number
    sdk::Float share;  // 0 where it is a, 1 where it is b
};

// A parabola where the numbers differ by less than `band`; a quarter of the band below where they
// are equal. A band of 0 is the minimum.
inline SmoothMinimum smooth_minimum(sdk::Float a, sdk::Float b, sdk::Float band) {
    using namespace sdk;
    const Float near = named("near", max(band - abs(a - b), 0));
    const Float half = named("half", divide(0.5 * near, band));
    return {min(a, b) - divide(near * near, 4 * band), select(a < b, half, 1 - half)};
}

}  // namespace wrinkle::nodes
