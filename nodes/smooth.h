// The lesser of two numbers with a rounded crease, for heights, masks and distances.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

struct SmoothMinimum {
    sdk::Float value;  // never above either number
    sdk::Float share;  // 0 where it is a, 1 where it is b
};

enum class Seam { quadratic, cubic, chamfer };

// Rounds or cuts the crease where the numbers differ by less than `band`. Where they are equal, the
// parabola is a quarter of the band below, the cubic a sixth. A chamfer is the straight cut of two
// distances at right angles, with ends a band from their crease. A band of 0 is the minimum.
inline SmoothMinimum smooth_minimum(sdk::Float a, sdk::Float b, sdk::Float band,
                                    Seam seam = Seam::quadratic) {
    using namespace sdk;
    const Float least = min(a, b);
    const Float near = named("near", max(band - abs(a - b), 0));
    const Float part = named("part", divide(near, band));
    const Float half = named("half", seam == Seam::cubic ? 0.5 * part * part : 0.5 * part);
    const Float share = select(a < b, half, 1 - half);
    if (seam == Seam::cubic) return {least - near * part * part * (1.0 / 6), share};
    if (seam == Seam::quadratic) return {least - divide(near * near, 4 * band), share};
    return {select(band > 0, min(least, (a + b - band) * 0.70710678118654752), least), share};
}

}  // namespace wrinkle::nodes
