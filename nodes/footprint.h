// How procedural relief is filtered, so that it does not shimmer far away.
//
// footprint(p)  how far a pixel reaches in the pattern's own coordinates: the longer of the changes
//               of p to the next pixel in x and in y. In cells where p counts cells.
// fade(w)       1 while the pixel is small in a cell, 0 where it covers most of one: 1 - smoothstep
//               from 0.25 to 0.75 cells (M. Mikkelsen's filtered noise). A layer of noise is
//               multiplied by it; a pattern with a mean of its own goes to that mean.
// spread(p)     the same by axes: the box around the pixel, for exact box filters.
// All are detached: they weigh a slope and add none. Differentials of zero mean a footprint of zero
// and every detail.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

template <class V>
sdk::Float footprint(V p) {
    return detach(max(length(ddx(p)), length(ddy(p))));
}

inline sdk::Float fade(sdk::Float footprint) {
    return 1 - sdk::smoothstep(0.25, 0.75, footprint);
}

template <class V>
V spread(V p) {
    return detach(fwidth(p));
}

}  // namespace wrinkle::nodes
