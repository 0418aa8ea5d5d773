// Smooth random relief in space. Random numbers come from integer hashes, so they are the same
// everywhere.
#include "nodes/noise.h"

#include "nodes/footprint.h"
#include "nodes/relief.h"

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

static Float value_at(Int x, Int y, Int z) {
    return unit_float(hash(x, y, z)) * 2 - 1;
}

static vec3 quintic(vec3 t) {
    return t * t * t * (t * (t * 6 - vec3(15)) + vec3(10));
}

// corner(x, y, z, way) of the eight corners of a cell, joined smoothly.
template <class Corner>
static Noise lattice_noise(const char* name, Corner corner) {
    return function(name, [corner](vec3 p) {
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

// The four corners of a simplex in the skewed lattice: the cell's, one step along the greatest
// component, one more along the next, and the opposite one.
static Noise simplex_function() {
    const auto slope = function("noise_corner", slope_at);
    const auto corner = function("simplex_corner", [slope](vec3 cell, vec3 way) {
        const Float near = max(0.5 - dot(way, way), 0);
        const Float square = near * near;
        return square * square * slope(Int(cell.x()), Int(cell.y()), Int(cell.z()), way);
    });
    return function("simplex_noise", [corner](vec3 p) {
        const vec3 skewed = p + dot(p, vec3(1)) * (1.0 / 3);
        const vec3 cell = floor(skewed);
        const vec3 f = skewed - cell;
        const Float xy(f.x() >= f.y()), xz(f.x() >= f.z()), yz(f.y() >= f.z());
        const vec3 rank(xy + xz, 1 - xy + yz, 2 - xz - yz);
        const vec3 way = f - dot(f, vec3(1)) * (1.0 / 6);
        const vec3 one = saturate(rank - 1), two = saturate(rank);
        return (corner(cell, way) + corner(cell + one, way - one + 1.0 / 6) +
                corner(cell + two, way - two + 1.0 / 3) + corner(cell + 1, way - 0.5)) *
               76.0;
    });
}

Noise noise_function(Basis basis) {
    if (basis == Basis::simplex) return simplex_function();
    if (basis == Basis::value) {
        const auto corner = function("value_corner", value_at);
        return lattice_noise("value_noise",
                             [corner](Int x, Int y, Int z, vec3) { return corner(x, y, z); });
    }
    return lattice_noise("gradient_noise", function("noise_corner", slope_at));
}

std::vector<Octave> octaves_of(const Fractal& fractal, const Layer& layer) {
    vec3 p = fractal.point;
    Float reach = footprint(p), weight = 1;
    std::vector<Octave> octaves{{layer(p, reach), weight}};
    for (int octave = 1; octave < fractal.octaves; ++octave) {
        p *= fractal.lacunarity;
        // Or every octave were 0 at the origin. Not scaled with p, which would cost it digits.
        const vec3 aside = vec3(19.19, 7.43, 31.71) * octave;
        reach *= detach(fractal.lacunarity);
        weight *= fractal.gain;
        octaves.push_back({layer(p + aside, reach), weight});
    }
    return octaves;
}

Float weighted_mean(const std::vector<Octave>& octaves) {
    Float sum = 0, total = 0;
    for (const Octave& octave : octaves) {
        sum += octave.height * octave.weight;
        total += octave.weight;
    }
    return sum / total;
}

Float fbm(const Fractal& fractal, Basis basis) {
    const Noise noise = noise_function(basis);
    const Layer layer = function(
        "noise_octave", [&](vec3 p, Float footprint) { return noise(p) * fade(footprint); });
    return weighted_mean(octaves_of(fractal, layer));
}

struct GradientNoise {
    vec3 point;
    Float scale;
    int octaves;
    Float lacunarity, gain, amplitude;
};

Node gradient_noise_node =
    relief(with_octaves(in_space(
               node("gradient_noise", "Gradient noise",
                    "Smooth random relief in space: octaves of Perlin noise, each finer and weaker "
                    "than the one before.")
                   .family("noise"),
               4)),
           0.02, "The noise, about -1 to 1, mostly within -0.5 to 0.5")
        .body([](GradientNoise in) {
            const Fractal fractal{in.point * in.scale, in.octaves, in.lacunarity, in.gain};
            return relief_of(fbm(fractal, Basis::gradient), in.amplitude);
        });

static auto single(Basis basis, vec3 point, Float scale, Float amplitude) {
    const vec3 p = point * scale;
    return relief_of(noise_function(basis)(p) * fade(footprint(p)), amplitude);
}

Node simplex_noise_node =
    relief(in_space(node("simplex_noise", "Simplex noise",
                         "Smooth random relief in space without the lattice's directions: one "
                         "octave of simplex noise.")
                        .family("noise"),
                    4),
           0.02, "The noise, about -1 to 1")
        .body([](vec3 point, Float scale, Float amplitude) {
            return single(Basis::simplex, point, scale, amplitude);
        });

Node value_noise_node =
    relief(in_space(node("value_noise", "Value noise",
                         "Soft random blotches in space: a random number in each corner of a cell, "
                         "joined smoothly.")
                        .family("noise"),
                    4),
           0.02, "The noise, -1 to 1")
        .body([](vec3 point, Float scale, Float amplitude) {
            return single(Basis::value, point, scale, amplitude);
        });

}  // namespace wrinkle::nodes
