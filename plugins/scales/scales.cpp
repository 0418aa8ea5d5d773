// An example plugin with a loop over the scales around a point; the result is the greatest height.
// The body is recorded once, and the generated shader contains a loop too.
#include <tuple>

#include "wrinkle/node.h"

using namespace wrinkle::sdk;

struct Scales {
    vec2 uv;
    Float density, radius, tilt, variation, amplitude;
};

// Height of a scale at the offset `way` from its middle: 0 outside, with a round rim, higher
// towards its tip along -v.
static Float scale_height(vec2 way, Float lift, const Scales& in) {
    const Float rim = named("rim", saturate(1.5 - 1.5 * dot(way, way) / (in.radius * in.radius)));
    return lift * rim * (0.5 - 0.5 * in.tilt * way.y() / in.radius);
}

static Node scales =
    node("scales", "Scales", "Scales of a fish or shingles of a roof, each over the row above.")
        .family("pattern")
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>("density", 10, "Scales per uv unit", slider(1, 40), unit("x"))
        .in<Float>("radius", 0.75, "Size of a scale, in distances of two", slider(0.5, 1),
                   limits(0.1, 1), unit("x"))
        .in<Float>("tilt", 0.7, "How much higher the tip is than the root", slider(0, 1),
                   limits(0, 1), unit("x"))
        .in<Float>("variation", 0.3, "How much lower some scales are than others", slider(0, 1),
                   limits(0, 1), unit("x"))
        .in<Float>("amplitude", 0.02, "Height of a scale, in length units of object space",
                   slider(0, 0.1), unit("m"))
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .body([](Scales in) {
            const vec2 p = in.uv * in.density;
            const Float row = named("row", floor(2 * p.y()));  // rows are half a unit apart
            // Four rows of two scales each: all scales within a distance of 1.
            const auto [last, highest] = loop(8, std::tuple{Int(0), Float(0)}, [&](Int i, Float h) {
                const Float y = row + Float(i >> 1) - 1;
                const Float shift = 0.5 * mod(y, 2.0);
                const Float x = floor(p.x() - shift) + Float(i & 1);
                const Float random = unit_float(hash(Int(x), Int(y)));
                const vec2 way = named("way", p - vec2(x + shift, 0.5 * y));
                const Float own = scale_height(way, 1 - in.variation * random, in);
                return std::tuple{i < 8, i + 1, max(h, own)};
            });
            return in.amplitude * highest;
        });

WRINKLE_PLUGIN("scales", "1.0", scales)
