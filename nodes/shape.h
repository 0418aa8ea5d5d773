// Ports that shapes share, and the uv as they see it. Distances are signed, negative inside, in uv
// units; exact unless the node's text differs, so their slopes have length 1. Formulas after
// I. Quilez, "2D distance functions".
#pragma once

#include "nodes/rotated.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {

constexpr auto shape_family(const char* id, const char* title, const char* doc) {
    return sdk::node(id, title, doc).family("shape");
}
constexpr auto shape(const char* id, const char* title, const char* doc) {
    return shape_family(id, title, doc)
        .in<sdk::vec2>("uv", sdk::surface::uv0, "Where to read it, on any uv set")
        .in<sdk::vec2>("center", 0.5, "The middle of the shape", sdk::slider(0, 1))
        .in<sdk::Float>("rotation", 0, "Angle of the shape, anticlockwise", sdk::slider(-180, 180),
                        sdk::unit("deg"));
}
template <class Declaration>
constexpr auto distance_out(const Declaration& declaration) {
    return declaration.template out<sdk::Float>("distance",
                                                "To the edge, negative inside, in uv units");
}
// The uv as seen from the shape.
inline sdk::vec2 local(sdk::vec2 uv, sdk::vec2 center, sdk::Float rotation) {
    return sdk::named("p", rotated(uv - center, -sdk::radians(rotation)));
}
}  // namespace wrinkle::nodes
