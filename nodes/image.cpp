// Nodes that read textures: colors, heights, slopes and normals.
#include <span>

#include "nodes/height_slope.h"
#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

struct HeightMap {
    Image image;
    vec2 uv;
    Float amplitude, midlevel;
    HeightQuality quality;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

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

struct TangentNormalMap {
    Image image;
    vec2 uv;
    Float strength;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

enum class Facing { toward, opposite };
static constinit Node image_list[] = {
    image_family("image", "Image", "The color of an image.")
        .in<Image>("image", "The image; sRGB unless it says otherwise", encoding("srgb"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .out<Color>("color", "Linear color")
        .out<Float>("alpha", "Opacity, 0 to 1")
        .out<Float>("red", "The red channel, linear")
        .out<Float>("green", "The green channel, linear")
        .out<Float>("blue", "The blue channel, linear")
        .body([](Image image, vec2 uv) {
            const vec4 texel = image.sample(uv);
            return std::tuple{texel.rgb(), texel.a(), texel.r(), texel.g(), texel.b()};
        }),

    in_frame(
        image_family("height_map", "Height map", "A relief from an image of its heights.")
            .in<Image>("image", height_map_doc, encoding("linear"))
            .in<vec2>("uv", surface::uv0, "Where to read it")
            .in<Float>("amplitude", 0.02, amplitude_doc, slider(0, 0.2), unit("m"))
            .in<Float>("midlevel", 0.5, "The value in the image that is height 0", slider(0, 1))
            .choice("quality", height_qualities, height_quality_doc),
        Scale::surface)
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .out<Gradient>("gradient", "Its bump, by the chosen scale")
        .body([](HeightMap in) {
            const Float height =
                (read_height(in.image, in.uv, in.quality) - in.midlevel) * in.amplitude;
            const bool exact = in.frame == FrameMethod::automatic || in.frame == FrameMethod::exact;
            const bool pixels = in.quality == HeightQuality::pixel;
            const bool on_surface = in.scale == Scale::surface && exact;
            if (on_surface && !pixels)
                return std::tuple{height, gradient_from_height(height, Base(in.base))};
            const FrameMethod method = on_surface ? FrameMethod::pixel : in.frame;
            const Frame basis = frame(in.uv, method, in.scale, in.direction);
            const vec2 slope = on_surface ? pixel_change(in.image, in.uv)
                                          : height_slope(in.image, in.uv, in.quality);
            const Derivative derivative(slope * in.amplitude, basis);
            return std::tuple{height, Gradient(derivative, Base(in.base))};
        }),

    slope_ports(image_family("derivative_map", "Derivative map",
                             "A bump from an image of slopes: dh/du in red, dh/dv in green.")
                    .in<Image>("image", "Slopes; 0.5 is flat unless it says otherwise",
                               encoding("derivative"))
                    .in<vec2>("uv", surface::uv0, "Where to read it"))
        .body([](DerivativeMap in) {
            return bump_of_slope(in.image.sample(in.uv).xy(), in.image, in);
        }),

    bump_in_frame(image_family("tangent_normal_map", "Tangent normal map",
                               "A bump from a tangent-space normal map. Slopes are limited to 128.")
                      .in<Image>("image", normal_map_doc, encoding("normal_gl"))
                      .in<vec2>("uv", surface::uv0, "Where to read it")
                      .in<Float>("strength", 1, strength_doc, slider(-2, 2), unit("x")),
                  Scale::unit)
        .body([](TangentNormalMap in) { return bump_of_normal(in.image.sample(in.uv).xyz(), in); }),

    image_family("object_normal_map", "Object normal map",
                 "A bump from a normal map in object space, so that it can be scaled and layered.")
        .in<Image>("image", "Object-space normals, any length", encoding("normal_gl"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>("strength", 1, strength_doc, slider(-2, 2), unit("x"))
        .choice("facing", {"toward", "opposite"},
                "A normal that points inward is mirrored at the surface (toward) or reversed "
                "(opposite)")
        .in<Normal>("base", surface::normal, base_doc)
        .out<Gradient>("gradient", "The bump")
        .body([](Image image, vec2 uv, Float strength, Facing facing, vec3 base) {
            const vec3 v = image.sample(uv).xyz();
            const Gradient g = facing == Facing::toward
                                   ? gradient_from_normal(v, Base(base))
                                   : gradient_from_outward_normal(v, Base(base));
            return g * strength;
        })};
constinit std::span<Node> image_nodes = image_list;

}  // namespace wrinkle::nodes
