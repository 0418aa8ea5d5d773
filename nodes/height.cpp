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
         "the mask is a step.")
        .family("height")
        .in<Height>("a", 0, "The height where the mask is 0, in length units of object space")
        .in<Height>("b", 0, "The height where the mask is 1, in length units of object space")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<Height>("height", "The mixed height, in length units of object space")
        .body([](Float a, Float b, Float mask) { return mix(a, b, mask); });

}  // namespace wrinkle::nodes
