// An example plugin with two outputs: a blend rule. The higher of two materials is visible, as sand
// that fills the joints between stones. The bumps are mixed; the heights only select the weight.
#include <tuple>

#include "wrinkle/node.h"

using namespace wrinkle::sdk;

struct Blend {
    Gradient a, b;
    Float height_a, height_b, level, softness;
};

static Node height_blend =
    node("height_blend", "Height blend", "Shows whichever of two materials is higher at a place.")
        .family("gradient")
        .in<Gradient>("a", "The bump of one material")
        .in<Gradient>("b", "The bump of the other")
        .in<Height>("height_a", 0, "The first height, in length units of object space", unit("m"))
        .in<Height>("height_b", 0, "The second height, in length units of object space", unit("m"))
        .in<Float>("level", 0, "Raises b over a, in length units of object space",
                   slider(-0.1, 0.1), unit("m"))
        .in<Float>("softness", 0.01,
                   "Over which difference in height one goes into the other, in length units of "
                   "object space",
                   slider(0.001, 0.1), limits(1e-6, 1e6), unit("m"))
        .out<Gradient>("gradient", "The bump of the higher one")
        .out<Float>("weight", "0 where a shows, 1 where b does; for colors")
        .body([](Blend in) {
            const Float above = in.height_b + in.level - in.height_a;
            const Float weight = saturate(0.5 + above / in.softness);
            return std::tuple{mix(in.a, in.b, weight), weight};
        });

WRINKLE_PLUGIN("height_blend", "1.0", height_blend)
