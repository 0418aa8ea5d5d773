// Ports that procedural heights share: a value without a unit, and a height, which is that value
// times an amplitude in length units of object space.
#pragma once

#include <tuple>

#include "wrinkle/node.h"

namespace wrinkle::nodes {

// Adds the last input, `amplitude`, and the outputs.
template <class Declaration>
constexpr auto relief(const Declaration& declaration, double amplitude, const char* value) {
    return declaration
        .template in<sdk::Float>("amplitude", amplitude,
                                 "Height where the value is 1, in length units of object space",
                                 sdk::slider(-0.2, 0.2), sdk::unit("m"))
        .template out<sdk::Height>(
            "height", "Value times amplitude, in length units of object space", sdk::unit("m"))
        .template out<sdk::Float>("value", value);
}

inline std::tuple<sdk::Float, sdk::Float> relief_of(sdk::Float value, sdk::Float amplitude) {
    return {value * amplitude, value};
}

// The first inputs of a pattern in space, and of a pattern on a uv set.
template <class Declaration>
constexpr auto in_space(const Declaration& declaration, double scale) {
    return declaration
        .template in<sdk::vec3>("point", sdk::surface::position,
                                "Where to read it; object space unless wired otherwise")
        .template in<sdk::Float>("scale", scale, "Cells per length unit", sdk::slider(0, 16),
                                 sdk::unit("x"));
}
template <class Declaration>
constexpr auto on_uv(const Declaration& declaration, const char* name, double scale,
                     const char* doc) {
    return declaration
        .template in<sdk::vec2>("uv", sdk::surface::uv0, "Where to read it, on any uv set")
        .template in<sdk::Float>(name, scale, doc, sdk::slider(0, 16), sdk::unit("x"));
}

}  // namespace wrinkle::nodes
