// Nodes that transform texture coordinates.
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static vec2 rotated(vec2 v, Float angle) {
    const Float c = cos(angle), s = sin(angle);
    const Float x = v.x(), y = v.y();
    return {c * x - s * y, s * x + c * y};
}

Node uv_transform_node =
    node("uv_transform", "UV transform", "A uv scaled, then turned about the origin, then moved.")
        .family("uv")
        .in<vec2>("uv", surface::uv0, "The uv to change")
        .in<vec2>("scale", 1, "How often a texture repeats per uv unit", slider(0, 16), unit("x"))
        .in<Float>("rotation", 0, "In degrees; the uv turns anticlockwise, textures clockwise",
                   slider(-180, 180), unit("deg"))
        .in<vec2>("offset", 0, "Added at the end, in uv units", slider(-1, 1))
        .out<vec2>("uv", "The changed uv")
        .body([](vec2 uv, vec2 scale, Float rotation, vec2 offset) {
            return rotated(uv * scale, radians(rotation)) + offset;
        });

}  // namespace wrinkle::nodes
