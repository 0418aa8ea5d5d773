// Relief from height maps.
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
        .choice("quality", HEIGHT_QUALITIES, HEIGHT_QUALITY_DOC)
        .choice("scale", SCALES, SCALE_DOC)
        .choice("frame", FRAME_METHODS, FRAME_DOC)
        .in<vec3>("direction", {0, 1, 0}, DIRECTION_DOC)
        .in<Normal>("base", surface::normal, BASE_DOC)
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
        });

}  // namespace wrinkle::nodes
