// An example plugin: one node with one formula. Its bump is the derivative, which Wrinkle computes.
#include "wrinkle/node.h"

using namespace wrinkle::sdk;

static Node ripples =
    node("ripples", "Ripples", "Rings around a point, as on water.")
        .family("pattern")
        .in<vec3>("point", surface::position,
                  "Where to read it; object space unless wired otherwise")
        .in<vec3>("centre", 0, "Where the rings begin, in length units of object space")
        .in<Float>("frequency", 8, "Rings per length unit", slider(0, 32), unit("x"))
        .in<Float>("amplitude", 0.01, "Height of a crest, in length units of object space",
                   slider(0, 0.1), unit("m"))
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .body([](vec3 point, vec3 centre, Float frequency, Float amplitude) {
            return amplitude * cos(2 * 3.14159265358979 * frequency * distance(point, centre));
        });

WRINKLE_PLUGIN("ripples", "1.0", ripples)
