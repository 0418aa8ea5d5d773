// Filters for procedural relief, against aliasing at a distance.
//
// footprint(p)  extent of a pixel in pattern coordinates: the longer of the screen differentials of
//               p in x and y. In cells if p counts cells.
// fade(w)       1 while the pixel is small relative to a cell, 0 if it covers most of one: 1 -
//               smoothstep from 0.25 to 0.75 cells (M. Mikkelsen's filtered noise). A layer of
//               noise is multiplied by it; a pattern with a non-zero mean fades to its mean.
// spread(p)     extent of the pixel per axis: the box around it, for exact box filters.
// lost_slope    a height of 0 that passes the variance of the slopes in p that a filter removed to
//               normal_variance(). Add it to the filtered height, outside of functions and loops.
//               For a pattern with flat parts, multiply the variance by the share of the area that
//               slopes: the highlight of flat parts is narrow, and one lobe with all the variance
//               would be too wide.
// box_width(x)  width of the box that has the variance of a number over the pixel, if it changes
//               linearly: the length of its screen differentials, whatever the pixel's rotation.
// All are detached: they weight a slope but do not contribute to it. Zero differentials give a zero
// footprint, which means full detail.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

template <class V>
sdk::Float footprint(V p) {
    return named("width", detach(max(length(ddx(p)), length(ddy(p)))));
}

inline sdk::Float fade(sdk::Float footprint) {
    return named("fade", 1 - sdk::smoothstep(0.25, 0.75, footprint));
}
// fade() of a pattern in p * scale, from the footprint of p.
inline sdk::Float fade(sdk::Float footprint, sdk::Float scale) {
    return fade(footprint * detach(abs(scale)));
}

// The share of the variance of slopes that a factor `fade` removes.
inline sdk::Float lost_share(sdk::Float fade) {
    return 1 - fade * fade;
}
// `variance`: of each component of the slope, uncorrelated; `covariance`: (xx, yy, xy).
inline sdk::Float lost_slope(sdk::vec3 p, sdk::Float variance) {
    return with_slope(0, p, with_covariance(sdk::vec3(0), detach(variance)));
}
inline sdk::Float lost_slope(sdk::vec2 p, sdk::vec3 covariance) {
    return with_slope(0, p, with_covariance(sdk::vec2(0), detach(covariance)));
}
inline sdk::Float lost_slope(sdk::vec2 p, sdk::Float variance) {
    return lost_slope(p, sdk::vec3(variance, variance, 0));
}

template <class V>
V spread(V p) {
    return detach(fwidth(p));
}

inline sdk::Float box_width(sdk::Float x) {
    return named("width", detach(length(sdk::vec2(ddx(x), ddy(x)))));
}

}  // namespace wrinkle::nodes
