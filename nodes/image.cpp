// Nodes that read textures: colours, and the four kinds of bump maps.
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

#define FRAME_METHODS \
    { "auto", "vertex", "derived", "exact", "guess" }
#define FRAME_DOC                                                                               \
    "What turns slopes into a bump: vertex tangents of uv0, derived from the uv, exact (keeps " \
    "stretch and skew), or guessed from a direction"
#define SCALES \
    { "surface", "unit" }
#define SCALE_DOC                                                                             \
    "surface: slopes are lengths of object space per uv unit; unit: slopes do not depend on " \
    "the size of the surface or on tiling"
#define BASE_DOC                                                                              \
    "The normal to put the bump on: the surface's, or that of a resolve, to bump its result " \
    "further"
#define DIRECTION_DOC "Tangent of the frame `guess`, in object space, any length"

Node image_node =
    node("image", "Image", "The colour of a picture.")
        .family("image")
        .in<Image>("image", "The picture; sRGB unless it says otherwise", encoding("srgb"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .out<Color>("color", "Linear colour")
        .out<Float>("alpha", "Opacity, 0 to 1")
        .out<Float>("red", "The red channel, linear")
        .out<Float>("green", "The green channel, linear")
        .out<Float>("blue", "The blue channel, linear")
        .body([](Image image, vec2 uv) {
            const vec4 texel = image.sample(uv);
            return std::tuple{texel.rgb(), texel.a(), texel.r(), texel.g(), texel.b()};
        });

// dh/d(u,v) by forward differences over one texel of the mip level in use, as in Mikkelsen's
// DerivFromHeightMap.
static vec2 filtered_slope(Image image, vec2 uv) {
    const vec2 size = image.size();
    const Float footprint = max(length(ddx(uv) * size), length(ddy(uv) * size));
    const vec2 texel = detach(max(footprint, 1) / size);
    const Float here = image.sample(uv).x();
    const Float right = image.sample(uv + vec2(texel.x(), 0)).x();
    const Float above = image.sample(uv + vec2(0, texel.y())).x();
    return vec2(right - here, above - here) / texel;
}

struct HeightMap {
    Image image;
    vec2 uv;
    Float amplitude, midlevel;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

Node height_map_node =
    node("height_map", "Height map", "A relief from a picture of its heights.")
        .family("image")
        .in<Image>("image",
                   "Heights from 0 to 1 in the red channel; linear unless it says otherwise",
                   encoding("linear"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>(
            "amplitude", 0.02,
            "Height of white over black, in length units of object space (in uv units for the "
            "scale `unit`)",
            slider(0, 0.2), unit("m"))
        .in<Float>("midlevel", 0.5, "The value in the picture that is height 0", slider(0, 1))
        .choice("scale", SCALES, SCALE_DOC)
        .choice("frame", FRAME_METHODS, FRAME_DOC)
        .in<vec3>("direction", {0, 1, 0}, DIRECTION_DOC)
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .out<Gradient>("gradient", "Its bump, by the chosen scale")
        .body([](HeightMap in) {
            const Float height = (in.image.sample(in.uv).x() - in.midlevel) * in.amplitude;
            const bool exact = in.frame == FrameMethod::automatic || in.frame == FrameMethod::exact;
            if (in.scale == Scale::surface && exact)
                return std::tuple{height, gradient_from_height(height, Base(in.base))};
            const Frame basis = frame(in.uv, in.frame, in.scale, in.direction);
            const vec2 slope = filtered_slope(in.image, in.uv) * in.amplitude;
            return std::tuple{height, Gradient(Derivative(slope, basis), Base(in.base))};
        });

enum class Per { uv, texel };
struct DerivativeMap {
    Image image;
    vec2 uv;
    Float strength;
    Per per;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

Node derivative_map_node =
    node("derivative_map", "Derivative map",
         "A bump from a picture of slopes: dh/du in red, dh/dv in green.")
        .family("image")
        .in<Image>("image", "Slopes; 0.5 is flat unless it says otherwise", encoding("derivative"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>("strength", 1,
                   "Factor of the slopes; for the scale `surface` a length of object space",
                   slider(-2, 2), unit("x"))
        .choice("per", {"uv", "texel"},
                "Whether the picture holds the change per uv unit or per texel")
        .choice("scale", SCALES, SCALE_DOC)
        .choice("frame", FRAME_METHODS, FRAME_DOC)
        .in<vec3>("direction", {0, 1, 0}, DIRECTION_DOC)
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Gradient>("gradient", "The bump")
        .out<Derivative>("derivative", "The slopes with their frame")
        .body([](DerivativeMap in) {
            const vec2 slope = in.image.sample(in.uv).xy() * in.strength;
            const Derivative d(in.per == Per::texel ? slope * in.image.size() : slope,
                               frame(in.uv, in.frame, in.scale, in.direction));
            return std::tuple{Gradient(d, Base(in.base)), d};
        });

struct TangentNormalMap {
    Image image;
    vec2 uv;
    Float strength;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

Node tangent_normal_map_node =
    node("tangent_normal_map", "Tangent normal map",
         "A bump from a tangent-space normal map. Slopes are limited to 128.")
        .family("image")
        .in<Image>("image", "Tangent-space normals; green is up unless it says otherwise",
                   encoding("normal_gl"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>("strength", 1,
                   "Factor of the slopes: 1 leaves it unchanged, negative inverts it",
                   slider(-2, 2), unit("x"))
        .choice("scale", SCALES, SCALE_DOC, static_cast<int>(Scale::unit))
        .choice("frame", FRAME_METHODS, FRAME_DOC)
        .in<vec3>("direction", {0, 1, 0}, DIRECTION_DOC)
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Gradient>("gradient", "The bump")
        .out<Derivative>("derivative", "The slopes with their frame")
        .body([](TangentNormalMap in) {
            const Derivative d = normal_derivative(in.image.sample(in.uv).xyz(), in.strength,
                                                   frame(in.uv, in.frame, in.scale, in.direction));
            return std::tuple{Gradient(d, Base(in.base)), d};
        });

enum class Facing { toward, opposite };
struct ObjectNormalMap {
    Image image;
    vec2 uv;
    Float strength;
    Facing facing;
    vec3 base;
};

Node object_normal_map_node =
    node("object_normal_map", "Object normal map",
         "A bump from a normal map in object space, so that it can be scaled and layered.")
        .family("image")
        .in<Image>("image", "Object-space normals, any length", encoding("normal_gl"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>("strength", 1,
                   "Factor of the slopes: 1 leaves it unchanged, negative inverts it",
                   slider(-2, 2), unit("x"))
        .choice("facing", {"toward", "opposite"},
                "A normal that points inward is mirrored at the surface (toward) or reversed "
                "(opposite)")
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Gradient>("gradient", "The bump")
        .body([](ObjectNormalMap in) {
            vec3 v = in.image.sample(in.uv).xyz();
            if (in.facing == Facing::opposite) v *= sign_nonzero(dot(in.base, v));
            return gradient_from_normal(v, Base(in.base)) * in.strength;
        });

}  // namespace wrinkle::nodes
