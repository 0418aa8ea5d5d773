// Procedural patterns in space. Random numbers come from integer hashes, so they are the same
// everywhere.
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

// The slope at a lattice point times the way to it: one of the twelve directions to the edges of a
// cube (K. Perlin 2002), of length sqrt(2).
static Float slope_at(Int x, Int y, Int z, vec3 way) {
    const Uint bits = hash(x, y, z);
    const Uint axis = ((bits >> 8u) * 3u) >> 24u;
    const Float a = select(axis == 0u, way.y(), way.x());
    const Float b = select(axis == 2u, way.y(), way.z());
    return select((bits & 1u) == 0u, a, -a) + select((bits & 2u) == 0u, b, -b);
}

static vec3 quintic(vec3 t) {
    return t * t * t * (t * (t * 6 - vec3(15)) + vec3(10));
}

// Perlin's gradient noise on the unit lattice: continuous to the second derivative, 0 at lattice
// points, within [-1, 1] but for a few percent.
static auto noise_function() {
    const auto corner = function("noise_corner", slope_at);
    return function("gradient_noise", [corner](vec3 p) {
        const vec3 cell = floor(p);
        const vec3 f = p - cell;
        const Int x(cell.x()), y(cell.y()), z(cell.z());
        const vec3 t = quintic(f);
        const auto row = [&](int dy, int dz) {
            return mix(corner(x, y + dy, z + dz, f - vec3(0, dy, dz)),
                       corner(x + 1, y + dy, z + dz, f - vec3(1, dy, dz)), t.x());
        };
        return mix(mix(row(0, 0), row(1, 0), t.y()), mix(row(0, 1), row(1, 1), t.y()), t.z());
    });
}

struct GradientNoise {
    vec3 point;
    Float scale;
    int octaves;
    Float lacunarity, gain, amplitude;
};

Node gradient_noise_node =
    node("gradient_noise", "Gradient noise",
         "Smooth random relief in space: octaves of Perlin noise, each finer and weaker than the "
         "one before.")
        .family("noise")
        .in<vec3>("point", surface::position,
                  "Where to read it; object space unless wired otherwise")
        .in<Float>("scale", 4, "Cells of the first octave per length unit", slider(0, 32),
                   unit("x"))
        .count("octaves", 4, 1, 8, "How many layers are added")
        .in<Float>("lacunarity", 2, "How much finer each octave is", slider(1, 4), unit("x"))
        .in<Float>("gain", 0.5, "How strong each octave is, relative to the one before",
                   slider(0, 1), limits(0, 1))
        .in<Float>("amplitude", 0.02,
                   "Height where the value is 1, in length units of object space", slider(0, 0.2),
                   unit("m"))
        .out<Height>("height", "Value times amplitude, in length units of object space", unit("m"))
        .out<Float>("value", "The noise, about -1 to 1, mostly within -0.5 to 0.5")
        .body([](GradientNoise in) {
            const auto noise = noise_function();
            vec3 p = in.point * in.scale;
            Float sum = noise(p), weight = 1, total = 1;
            for (int octave = 1; octave < in.octaves; ++octave) {
                p = p * in.lacunarity +
                    vec3(19.19, 7.43, 31.71);  // or every octave were 0 at the origin
                weight *= in.gain;
                sum += noise(p) * weight;
                total += weight;
            }
            const Float value = sum / total;
            return std::tuple{value * in.amplitude, value};
        });

}  // namespace wrinkle::nodes
