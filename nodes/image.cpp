// Nodes that read textures: colours, slopes and normals. Heights are in height_map.cpp.
#include "nodes/ports.h"
#include "nodes/slope_map.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

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

struct DerivativeMap {
    Image image;
    vec2 uv;
    Float strength;
    PerLength per;
    bool flip_u, flip_v;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

Node derivative_map_node =
    slope_ports(node("derivative_map", "Derivative map",
                     "A bump from a picture of slopes: dh/du in red, dh/dv in green.")
                    .family("image")
                    .in<Image>("image", "Slopes; 0.5 is flat unless it says otherwise",
                               encoding("derivative"))
                    .in<vec2>("uv", surface::uv0, "Where to read it"))
        .body([](DerivativeMap in) {
            return bump_of_slope(in.image.sample(in.uv).xy(), in.image, in);
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
            const vec3 v = in.image.sample(in.uv).xyz();
            const Gradient g = in.facing == Facing::toward
                                   ? gradient_from_normal(v, Base(in.base))
                                   : gradient_from_outward_normal(v, Base(in.base));
            return g * in.strength;
        });

}  // namespace wrinkle::nodes
