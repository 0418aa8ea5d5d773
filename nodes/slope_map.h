// Common parts of nodes that read slopes dh/d(u,v) from an image: the ports after the image, and
// the bump of the slope.
#pragma once

#include <tuple>

#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {

enum class PerLength { uv, texel };

// Adds the ports from `strength` on, and the outputs.
template <class Declaration>
constexpr auto slope_ports(const Declaration& declaration) {
    return declaration
        .template in<sdk::Float>(
            "strength", 1, "Factor of the slopes; for the scale `surface` a length of object space",
            sdk::slider(-2, 2), sdk::unit("x"))
        .choice("per", {"uv", "texel"},
                "Whether the picture holds the change per uv unit or per texel")
        .flag("flip_u", false, "Turns the slopes along u about: for maps whose red points down")
        .flag("flip_v", false, "Turns the slopes along v about: for maps with v pointing down")
        .choice("scale", SCALES, SCALE_DOC)
        .choice("frame", FRAME_METHODS, FRAME_DOC)
        .template in<sdk::vec3>("direction", {0, 1, 0}, DIRECTION_DOC)
        .template in<sdk::Normal>("base", sdk::surface::normal, BASE_DOC)
        .template out<sdk::Gradient>("gradient", "The bump")
        .template out<sdk::Derivative>("derivative", "The slopes with their frame");
}

// Returns the bump of a slope as stored in `image`; `in` holds the values of those ports, and `uv`.
template <class In>
std::tuple<sdk::Gradient, sdk::Derivative> bump_of_slope(sdk::vec2 read, const sdk::Image& image,
                                                         const In& in) {
    const sdk::vec2 flip(in.flip_u ? -1 : 1, in.flip_v ? -1 : 1);
    const sdk::vec2 slope = read * flip * in.strength;
    const sdk::Derivative d(in.per == PerLength::texel ? slope * image.size() : slope,
                            frame(in.uv, in.frame, in.scale, in.direction));
    return {sdk::Gradient(d, sdk::Base(in.base)), d};
}

}  // namespace wrinkle::nodes
