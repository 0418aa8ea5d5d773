// An example plugin with a choice: the body is compiled for each of its names, so the shader
// contains only the chosen branch. All choices but `hollows` use only the gradient, so they work
// with every kind of bump.
#include <tuple>

#include "wrinkle/node.h"

using namespace wrinkle::sdk;

// In the order of the choice's names.
enum class Where { hollows, flats, edges, below };

// Returns the tendency to rust at a point, before `amount` and `hardness` are applied: 0 none, 1
// full.
static Float exposure(Where where, Gradient bump, Float height, Float depth) {
    const Float slope = length(bump.vector());  // tangent of the angle to the smooth surface
    if (where == Where::hollows) return 0.5 - divide(height, 2 * depth);
    if (where == Where::flats) return 1 / (1 + slope * slope);
    if (where == Where::edges) return slope / (1 + slope);
    return 0.5 - 0.5 * resolve(bump).y();
}

struct Rust {
    Gradient metal, rust;
    Float height;
    Where where;
    Float amount, hardness, depth;
};

static Node rust =
    node("rust", "Rust", "Lays rust over a bump: in hollows, on flats, on edges or from below.")
        .family("gradient")
        .in<Gradient>("metal", "The bump that rusts")
        .in<Gradient>("rust", "The bump of the rust itself")
        .in<Height>("height", 0,
                    "Height of the metal, for hollows, in length units of object space", unit("m"))
        .choice("where", {"hollows", "flats", "edges", "below"},
                "Where it begins: below a height of 0, where the bump is gentle, where it is "
                "steep, or where it looks down")
        .in<Float>("amount", 0.5, "How far it has come: 0 nowhere, 1 everywhere", slider(0, 1),
                   limits(0, 1), unit("x"))
        .in<Float>("hardness", 6, "Width of the rim between metal and rust; 1 is a wide wash",
                   slider(1, 20), limits(1, 100), unit("x"))
        .in<Float>("depth", 0.02, "Heights go from -depth to depth, in length units",
                   slider(0.001, 0.1), limits(1e-6, 1e6), unit("m"))
        .out<Gradient>("gradient", "Metal and rust")
        .out<Float>("mask", "0 on metal, 1 on rust; for color and roughness")
        .body([](Rust in) {
            const Float exposed = exposure(in.where, in.metal, in.height, in.depth);
            const Float mask = saturate((exposed + in.amount - 1) * in.hardness + in.amount);
            return std::tuple{mix(in.metal, in.rust, mask), mask};
        });

WRINKLE_PLUGIN("rust", "1.0", rust)
