// Nodes on heights: lengths of object space, positive outward. Their bump is the exact derivative.
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

Node height_add_node = node("height_add", "Add heights", "Lays one relief on top of another.")
                           .family("height")
                           .in<Height>("a", 0, "One height, in length units of object space")
                           .in<Height>("b", 0, "The other height, in length units of object space")
                           .out<Height>("height", "The sum, in length units of object space")
                           .body([](Float a, Float b) { return a + b; });

Node height_subtract_node =
    node("height_subtract", "Subtract heights",
         "Carves one relief into another: what stands out of b is cut into a.")
        .family("height")
        .in<Height>("a", 0, "The height to carve into, in length units of object space")
        .in<Height>("b", 0, "The height that is cut in, in length units of object space")
        .out<Height>("height", "The difference, in length units of object space")
        .body([](Float a, Float b) { return a - b; });

Node height_scale_node =
    node("height_scale", "Scale height", "Makes a relief deeper or shallower; 0 is flat.")
        .family("height")
        .in<Height>("height", 0, "In length units of object space")
        .in<Float>("amount", 1, "Factor: 1 leaves it unchanged, negative inverts it", slider(-2, 2),
                   unit("x"))
        .out<Height>("height", "The scaled height, in length units of object space")
        .body([](Float height, Float amount) { return height * amount; });

Node height_mix_node =
    node("height_mix", "Mix heights",
         "Goes from one relief to another. Its bump includes the slope of the mask, so an edge of "
         "the mask is a step; gradient_mix leaves it out.")
        .family("height")
        .in<Height>("a", 0, "The height where the mask is 0, in length units of object space")
        .in<Height>("b", 0, "The height where the mask is 1, in length units of object space")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<Height>("height", "The mixed height, in length units of object space")
        .body([](Float a, Float b, Float mask) { return mix(a, b, mask); });

Node height_invert_node =
    node("height_invert", "Invert height", "Turns hills into dents and dents into hills.")
        .family("height")
        .in<Height>("height", 0, "In length units of object space")
        .in<Height>("level", 0, "The height that stays, in length units of object space",
                    slider(-0.1, 0.1), unit("m"))
        .out<Height>("height", "The inverted height, in length units of object space")
        .body([](Float height, Float level) { return 2 * level - height; });

// Smooth maximum: quadratic within `width` of equal heights, so value and slope are continuous. A
// width of 0 gives the plain maximum.
static Float smooth_max(Float a, Float b, Float width) {
    const Float apart = abs(a - b);
    const Float rest = max(width - apart, 0);
    return max(a, b) + divide(rest * rest, 4 * width);
}

#define SMOOTHNESS_DOC                                                                          \
    "Heights closer than this are rounded into each other, in length units of object space; 0 " \
    "leaves a sharp crease"

Node height_max_node =
    node("height_max", "Higher of two heights",
         "One relief stands in another, as stones stand out of sand.")
        .family("height")
        .in<Height>("a", 0, "One height, in length units of object space")
        .in<Height>("b", 0, "The other height, in length units of object space")
        .in<Height>("smoothness", 0, SMOOTHNESS_DOC, slider(0, 0.1), limits(0, 1e6), unit("m"))
        .out<Height>("height", "The higher one, in length units of object space")
        .body([](Float a, Float b, Float width) { return smooth_max(a, b, width); });

Node height_min_node =
    node("height_min", "Lower of two heights",
         "One relief cuts off another, as a worn top cuts off bumps.")
        .family("height")
        .in<Height>("a", 0, "One height, in length units of object space")
        .in<Height>("b", 0, "The other height, in length units of object space")
        .in<Height>("smoothness", 0, SMOOTHNESS_DOC, slider(0, 0.1), limits(0, 1e6), unit("m"))
        .out<Height>("height", "The lower one, in length units of object space")
        .body([](Float a, Float b, Float width) { return -smooth_max(-a, -b, width); });

struct HeightRemap {
    Float height, from_low, from_high, to_low, to_high;
    bool clamped;
};

Node height_remap_node =
    node("height_remap", "Remap height",
         "Brings heights of one range to another, as a value of 0 to 1 to lengths.")
        .family("height")
        .in<Height>("height", 0, "In length units of object space, or a value")
        .in<Float>("from_low", 0, "What becomes to_low", slider(-1, 1))
        .in<Float>("from_high", 1, "What becomes to_high", slider(-1, 1))
        .in<Height>("to_low", 0, "In length units of object space", slider(-0.1, 0.1), unit("m"))
        .in<Height>("to_high", 0.02, "In length units of object space", slider(-0.1, 0.1),
                    unit("m"))
        .flag("clamped", true, "Whether heights out of the range stay at its ends, as plateaus")
        .out<Height>("height", "In length units of object space")
        .body([](HeightRemap in) {
            const Float t = divide(in.height - in.from_low, in.from_high - in.from_low);
            return mix(in.to_low, in.to_high, in.clamped ? saturate(t) : t);
        });

}  // namespace wrinkle::nodes
