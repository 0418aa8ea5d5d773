// Ports that several nodes share: their choices and documentation, and whole groups of them.
#pragma once

#include <tuple>

#include "wrinkle/node.h"

namespace wrinkle::nodes {

inline constexpr const char* frame_methods[] = {"auto", "vertex", "derived", "exact", "guess"};
inline constexpr char frame_doc[] =
    "The frame of the slopes: vertex tangents of uv0, derived from the uv, exact (keeps "
    "stretch and skew), or guessed from a direction";
inline constexpr const char* scales[] = {"surface", "unit"};
inline constexpr char scale_doc[] =
    "surface: slopes are lengths of object space per uv unit; unit: slopes do not depend on "
    "the size of the surface or on tiling. On a projection of the position, surface is the bump "
    "that triplanar nodes make";
inline constexpr char base_doc[] =
    "The normal to put the bump on: the surface's, or that of a resolve, to bump its result "
    "further";
inline constexpr char direction_doc[] = "Tangent of the frame `guess`, in object space, any length";
inline constexpr char strength_doc[] =
    "Factor of the slopes: 1 leaves it unchanged, negative inverts it";
inline constexpr char normal_map_doc[] =
    "Tangent-space normals; green is up unless it says otherwise";
inline constexpr char height_map_doc[] =
    "Heights from 0 to 1 in the red channel; linear unless it says otherwise";
inline constexpr char amplitude_doc[] =
    "Height of white over black, in length units of object space (in uv units for the scale "
    "`unit`)";

constexpr auto image_family(const char* id, const char* title, const char* doc) {
    return sdk::node(id, title, doc).family("image");
}
constexpr auto gradient_family(const char* id, const char* title, const char* doc) {
    return sdk::node(id, title, doc).family("gradient");
}

// Adds the frame and the base of a bump.
template <class Declaration>
constexpr auto in_frame(const Declaration& declaration, sdk::Scale scale) {
    return declaration.choice("scale", scales, scale_doc, static_cast<int>(scale))
        .choice("frame", frame_methods, frame_doc)
        .template in<sdk::vec3>("direction", {0, 1, 0}, direction_doc)
        .template in<sdk::Normal>("base", sdk::surface::normal, base_doc);
}

// Adds the same, and the outputs of a bump that was made of slopes in that frame.
template <class Declaration>
constexpr auto bump_in_frame(const Declaration& declaration, sdk::Scale scale) {
    return in_frame(declaration, scale)
        .template out<sdk::Gradient>("gradient", "The bump")
        .template out<sdk::Derivative>("derivative", "The slopes with their frame");
}
inline std::tuple<sdk::Gradient, sdk::Derivative> bump_of(const sdk::Derivative& slopes,
                                                          sdk::vec3 base) {
    return {sdk::Gradient(slopes, sdk::Base(base)), slopes};
}
// Returns the bump of a tangent-space normal.
template <class In>
std::tuple<sdk::Gradient, sdk::Derivative> bump_of_normal(sdk::vec3 normal, const In& in) {
    const sdk::Frame basis = frame(in.uv, in.frame, in.scale, in.direction);
    return bump_of(normal_derivative(normal, in.strength, basis), in.base);
}

enum class PerLength { uv, texel };

// Adds the ports of a map of slopes dh/d(u,v) from `strength` on, and the outputs.
template <class Declaration>
constexpr auto slope_ports(const Declaration& declaration) {
    return bump_in_frame(
        declaration
            .template in<sdk::Float>(
                "strength", 1,
                "Factor of the slopes; for the scale `surface` a length of object space",
                sdk::slider(-2, 2), sdk::unit("x"))
            .choice("per", {"uv", "texel"},
                    "Unit of the slopes in the image: change per uv unit or per texel")
            .flag("flip_u", false, "Turns the slopes along u about: for maps whose red points down")
            .flag("flip_v", false, "Turns the slopes along v about: for maps with v pointing down"),
        sdk::Scale::surface);
}

// Returns the bump of a slope as stored in `image`; `in` holds the values of those ports, and `uv`.
template <class In>
std::tuple<sdk::Gradient, sdk::Derivative> bump_of_slope(sdk::vec2 read, const sdk::Image& image,
                                                         const In& in) {
    const sdk::vec2 flip(in.flip_u ? -1 : 1, in.flip_v ? -1 : 1);
    const sdk::vec2 slope = read * flip * in.strength;
    return bump_of(sdk::Derivative(in.per == PerLength::texel ? slope * image.size() : slope,
                                   frame(in.uv, in.frame, in.scale, in.direction)),
                   in.base);
}

}  // namespace wrinkle::nodes
