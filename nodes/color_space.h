// Colors in other spaces. Colors of the graph are linear Rec. 709; all functions are defined for
// every number.
//
// luminance(c)         of Rec. 709: 0.2126 R + 0.7152 G + 0.0722 B
// encoded, decoded     to and from sRGB display values, by component; negatives count as 0
// to_oklab, from_oklab   (lightness, a, b) of B. Ottosson 2020
// to_hsv, from_hsv       (hue in turns, saturation, value) on linear components; a grey has hue 0
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

enum class Space { linear, display, oklab };

inline sdk::Float luminance(sdk::vec3 color) {
    return dot(color, sdk::vec3(0.2126, 0.7152, 0.0722));
}

sdk::vec3 encoded(sdk::vec3 linear);
sdk::vec3 decoded(sdk::vec3 display);
sdk::vec3 to_oklab(sdk::vec3 linear);
sdk::vec3 from_oklab(sdk::vec3 lab);
sdk::vec3 to_hsv(sdk::vec3 linear);
sdk::vec3 from_hsv(sdk::vec3 hsv);

// Linear to `space`, and back.
sdk::vec3 in_space(Space space, sdk::vec3 linear);
sdk::vec3 from_space(Space space, sdk::vec3 color);

}  // namespace wrinkle::nodes
