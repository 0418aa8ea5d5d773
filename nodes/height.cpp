// Nodes on heights: lengths of object space, positive outward. Their bump is the exact derivative.
#include <span>

#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto height_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("height");
}

// Smooth maximum: quadratic within `width` of equal heights, so value and slope are continuous. A
// width of 0 gives the plain maximum.
static Float smooth_max(Float a, Float b, Float width) {
    const Float apart = abs(a - b);
    const Float rest = max(width - apart, 0);
    return max(a, b) + divide(rest * rest, 4 * width);
}

constexpr char smoothness_doc[] =
    "Heights closer than this are rounded into each other, in length units of object space; 0 "
    "leaves a sharp crease";

static constinit Node height_list[] = {
    height_family("height_add", "Add heights", "Lays one relief on top of another.")
        .in<Height>("a", 0, "One height, in length units of object space")
        .in<Height>("b", 0, "The other height, in length units of object space")
        .out<Height>("height", "The sum, in length units of object space")
        .body([](Float a, Float b) { return a + b; }),

    height_family("height_subtract", "Subtract heights",
                  "Carves one relief into another: what stands out of b is cut into a.")
        .in<Height>("a", 0, "The height to carve into, in length units of object space")
        .in<Height>("b", 0, "The height that is cut in, in length units of object space")
        .out<Height>("height", "The difference, in length units of object space")
        .body([](Float a, Float b) { return a - b; }),

    height_family("height_scale", "Scale height", "Makes a relief deeper or shallower; 0 is flat.")
        .in<Height>("height", 0, "In length units of object space")
        .in<Float>("amount", 1, "Factor: 1 leaves it unchanged, negative inverts it", slider(-2, 2),
                   unit("x"))
        .out<Height>("height", "The scaled height, in length units of object space")
        .body([](Float height, Float amount) { return height * amount; }),

    height_family("height_invert", "Invert height", "Turns hills into dents and dents into hills.")
        .in<Height>("height", 0, "In length units of object space")
        .in<Height>("level", 0, "The height that stays, in length units of object space",
                    slider(-0.1, 0.1), unit("m"))
        .out<Height>("height", "The inverted height, in length units of object space")
        .body([](Float height, Float level) { return 2 * level - height; }),

    height_family(
        "height_mix", "Mix heights",
        "Goes from one relief to another. Its bump includes the slope of the mask, so an edge of "
        "the mask is a step; gradient_mix leaves it out.")
        .in<Height>("a", 0, "The height where the mask is 0, in length units of object space")
        .in<Height>("b", 0, "The height where the mask is 1, in length units of object space")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<Height>("height", "The mixed height, in length units of object space")
        .body([](Float a, Float b, Float mask) { return mix(a, b, mask); }),

    height_family("height_max", "Higher of two heights",
                  "One relief rises out of another, as stones out of sand.")
        .in<Height>("a", 0, "One height, in length units of object space")
        .in<Height>("b", 0, "The other height, in length units of object space")
        .in<Height>("smoothness", 0, smoothness_doc, slider(0, 0.1), limits(0, 1e6), unit("m"))
        .out<Height>("height", "The higher one, in length units of object space")
        .body([](Float a, Float b, Float width) { return smooth_max(a, b, width); }),

    height_family("height_min", "Lower of two heights",
                  "One relief cuts off another, as a worn top cuts off bumps.")
        .in<Height>("a", 0, "One height, in length units of object space")
        .in<Height>("b", 0, "The other height, in length units of object space")
        .in<Height>("smoothness", 0, smoothness_doc, slider(0, 0.1), limits(0, 1e6), unit("m"))
        .out<Height>("height", "The lower one, in length units of object space")
        .body([](Float a, Float b, Float width) { return -smooth_max(-a, -b, width); }),

    height_family("height_remap", "Remap height",
                  "Brings heights of one range to another, as a value of 0 to 1 to lengths.")
        .in<Height>("height", 0, "In length units of object space, or a value")
        .in<Float>("from_low", 0, "Mapped to to_low", slider(-1, 1))
        .in<Float>("from_high", 1, "Mapped to to_high", slider(-1, 1))
        .in<Height>("to_low", 0, "In length units of object space", slider(-0.1, 0.1), unit("m"))
        .in<Height>("to_high", 0.02, "In length units of object space", slider(-0.1, 0.1),
                    unit("m"))
        .flag("clamped", true, "Clamps heights out of the range to its ends, as plateaus")
        .out<Height>("height", "In length units of object space")
        .body([](Float height, Float from_low, Float from_high, Float to_low, Float to_high,
                 bool clamped) {
            const Float t = divide(height - from_low, from_high - from_low);
            return mix(to_low, to_high, clamped ? saturate(t) : t);
        })};
constinit std::span<Node> height_nodes = height_list;

}  // namespace wrinkle::nodes
