// Common blends of two unit tangent-space normals, for comparison with the addition of slopes.
#pragma once

#include "wrinkle/node.h"

namespace wrinkle::nodes {

constexpr auto comparison_family(const char* id, const char* title, const char* doc) {
    return sdk::node(id, title, doc).family("comparison");
}

inline sdk::vec3 linear_blend(sdk::vec3 a, sdk::vec3 b) {
    return normalize(a + b);
}

inline sdk::vec3 whiteout_blend(sdk::vec3 a, sdk::vec3 b) {
    return normalize(sdk::vec3(a.xy() + b.xy(), a.z() * b.z()));
}

inline sdk::vec3 udn_blend(sdk::vec3 a, sdk::vec3 b) {
    return normalize(sdk::vec3(a.xy() + b.xy(), a.z()));
}

inline sdk::vec3 partial_derivative_blend(sdk::vec3 a, sdk::vec3 b) {
    return normalize(sdk::vec3(a.xy() * b.z() + b.xy() * a.z(), a.z() * b.z()));
}

inline sdk::vec3 rnm_blend(sdk::vec3 a, sdk::vec3 b) {
    const sdk::vec3 t = a + sdk::vec3(0, 0, 1), u = b * sdk::vec3(-1, -1, 1);
    return normalize(t * divide(dot(t, u), t.z()) - u);
}

}  // namespace wrinkle::nodes
