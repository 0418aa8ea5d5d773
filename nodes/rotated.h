// A vector of the plane turned anticlockwise by an angle in radians.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

inline sdk::vec2 rotated(sdk::vec2 v, sdk::Float angle) {
    const sdk::Float c = cos(angle), s = sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

}  // namespace wrinkle::nodes
