// Ports that procedural heights share: a value without a unit, and a height, which is that value
// times an amplitude in length units of object space.
#pragma once

#include <tuple>

#include "wrinkle/node.h"

namespace wrinkle::nodes {

// Begins a node of noise in space, and one of a pattern on a uv set.
constexpr auto noise_in_space(const char* id, const char* title, const char* doc, double scale) {
    return sdk::node(id, title, doc)
        .family("noise")
        .in<sdk::vec3>("point", sdk::surface::position,
                       "Where to read it; object space unless wired otherwise")
        .in<sdk::Float>("scale", scale, "Cells per length unit", sdk::slider(0, 16),
                        sdk::unit("x"));
}
constexpr auto pattern_on_uv(const char* id, const char* title, const char* doc,
                             const char* scale_name, double scale, const char* scale_doc) {
    return sdk::node(id, title, doc)
        .family("pattern")
        .in<sdk::vec2>("uv", sdk::surface::uv0, "Where to read it, on any uv set")
        .in<sdk::Float>(scale_name, scale, scale_doc, sdk::slider(0, 16), sdk::unit("x"));
}

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

}  // namespace wrinkle::nodes
