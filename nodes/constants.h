// Constants of several families, with their names in generated source.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

// Areas and sums below it count as zero.
inline sdk::Float min_area() {
    return sdk::named("min_area // smaller areas and squared lengths are zero", sdk::Float(1e-36));
}
inline sdk::Float sin_60() {
    return sdk::named("sin_60 // sqrt(3) / 2", sdk::Float(0.8660254037844386));
}
// The mean of a pattern's heights, which a pixel sees that covers it.
inline sdk::Float mean_height(sdk::Float mean) {
    return sdk::named("mean // height of the pattern, seen from far away", mean);
}

}  // namespace wrinkle::nodes
