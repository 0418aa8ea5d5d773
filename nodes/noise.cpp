// Smooth random relief in space. Random numbers come from integer hashes, so they are the same on
// every target.
#include <span>

#include "nodes/noise.h"

#include "nodes/footprint.h"
#include "nodes/random.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

// Returns (slope, height) of a corner of the lattice with these random bits, at the position
// corner + way: one of the twelve directions to the edges of a cube (K. Perlin 2002), of length
// sqrt(2), and its product with way.
static vec4 gradient_corner(Uint bits, vec3 way) {
    const auto from = function("gradient_corner(bits, way)", [](Uint bits, vec3 way) {
        const Uint third = named("third // a third of all hashes", Uint(0x55555600u));
        const Uint two_thirds = named("two_thirds // of all hashes", Uint(0xaaaaab00u));
        const Bool no_x = named("no_x", bits < third), no_z = named("no_z", bits >= two_thirds);
        const Float a = named("a", 1 - 2 * Float(bits & 1u)), b = named("b", 1 - Float(bits & 2u));
        const Float x = named("x", select(no_x, 0, a)), z = named("z", select(no_z, 0, b));
        const Float y = named("y", a - x + b - z);
        return vec4(x, y, z, dot(vec3(x, y, z), way));
    });
    return from(bits, way);
}

// Perlin's quintic of a position in a cell, by component, and its derivative.
struct Quintic {
    vec3 t, dt;
};
static Quintic quintic(vec3 f) {
    const vec3 back = named("back", f - 1);
    return {named("t", f * f * f * (f * (f * 6 - vec3(15)) + vec3(10))),
            named("dt", 30 * f * f * back * back)};
}

// Calls cell(bits of four edges, position in the cell). The edges run along x; they begin at the
// corner, a step along y from it, a step along z, and a step along both. hash(bits) and
// hash(bits + 1u) are hash(Int, Int, Int) of an edge's corners.
template <class CellFunction>
static vec4 in_cell(vec3 p, int seed, CellFunction cell) {
    const vec3 corner = named("cell", floor(p)), at = seeded_cell(corner, seed);
    const Uint x = named("x", Uint(Int(at.x()))), y = named("y", Uint(Int(at.y())));
    const Uint z = named("z", Uint(Int(at.z()))), y_1 = named("y_1", y + 1u);
    const Uint z_bits = named("z_bits", hash(z)), z_bits_1 = named("z_bits_1", hash(z + 1u));
    return cell(named("bits", x + hash(y + z_bits)), named("bits_y", x + hash(y_1 + z_bits)),
                named("bits_z", x + hash(y + z_bits_1)), named("bits_yz", x + hash(y_1 + z_bits_1)),
                p - corner);
}

// Interpolates (slope, height) of the eight corners: along x, then y, then z. Each step adds the
// slope along its axis.
static vec4 gradient_cell(Uint bits, Uint bits_y, Uint bits_z, Uint bits_yz, vec3 f) {
    const auto edge =
        function("gradient_edge(bits, way, t, dt)", [](Uint bits, vec3 way, Float t, Float dt) {
            const vec4 a = named("a", gradient_corner(hash(bits), way));
            const vec4 b = named("b", gradient_corner(hash(bits + 1u), way - vec3(1, 0, 0)));
            return named("mixed", mix(a, b, t)) + vec4(dt * (b.w() - a.w()), 0, 0, 0);
        });
    const auto [t, dt] = quintic(f);
    const vec4 a = named("a", edge(bits, f, t.x(), dt.x()));
    const vec4 b = named("b", edge(bits_y, f - vec3(0, 1, 0), t.x(), dt.x()));
    const vec4 c = named("c", edge(bits_z, f - vec3(0, 0, 1), t.x(), dt.x()));
    const vec4 d = named("d", edge(bits_yz, f - vec3(0, 1, 1), t.x(), dt.x()));
    const vec4 y(0, dt.y(), 0, 0), z(0, 0, dt.z(), 0);
    const vec4 low = named("low", named("ab", mix(a, b, t.y())) + y * (b.w() - a.w()));
    const vec4 high = named("high", named("cd", mix(c, d, t.y())) + y * (d.w() - c.w()));
    return named("joined", mix(low, high, t.z())) + z * (high.w() - low.w());
}
static vec4 gradient_noise(vec3 p, int seed) {
    return in_cell(p, seed,
                   function("gradient_cell(bits, bits_y, bits_z, bits_yz, f)", gradient_cell));
}

// The same for corners that have only a height: each step makes one component of the slope.
static vec4 value_cell(Uint bits, Uint bits_y, Uint bits_z, Uint bits_yz, vec3 f) {
    const auto [t, dt] = quintic(f);
    const auto edge = function("value_edge(bits, t, dt)", [](Uint bits, Float t, Float dt) {
        const Float a = named("a", unit_float(hash(bits)) * 2 - 1);
        const Float b = named("b", unit_float(hash(bits + 1u)) * 2 - 1);
        return vec2(dt * (b - a), mix(a, b, t));
    });
    const auto along_y = [&t = t, &dt = dt](vec2 a, vec2 b) {
        const vec2 mixed = mix(a, b, t.y());
        return vec3(mixed.x(), dt.y() * (b.y() - a.y()), mixed.y());
    };
    const vec2 a = named("a", edge(bits, t.x(), dt.x())),
               b = named("b", edge(bits_y, t.x(), dt.x()));
    const vec2 c = named("c", edge(bits_z, t.x(), dt.x())),
               d = named("d", edge(bits_yz, t.x(), dt.x()));
    const vec3 low = named("low", along_y(a, b)), high = named("high", along_y(c, d));
    const vec3 mixed = named("mixed", mix(low, high, t.z()));
    return vec4(mixed.xy(), vec2(dt.z() * (high.z() - low.z()), mixed.z()));
}
static vec4 value_noise(vec3 p, int seed) {
    return in_cell(p, seed, function("value_cell(bits, bits_y, bits_z, bits_yz, f)", value_cell));
}

// Sums the four corners of a simplex in the skewed lattice: the cell's corner, one step along the
// greatest component, one more along the next, and the opposite corner. Returns (slope, height).
static vec4 simplex(vec3 p, int seed) {
    const vec3 skewed = named("skewed", p + dot(p, vec3(1)) / 3);
    const vec3 corner = named("cell", floor(skewed)), f = named("f", skewed - corner);
    const vec3 cell = seeded_cell(corner, seed);
    const Float xy(f.x() >= f.y()), xz(f.x() >= f.z()), yz(f.y() >= f.z());
    const vec3 rank = named("rank", vec3(xy + xz, 1 - xy + yz, 2 - xz - yz));
    const vec3 way = named("way", f - dot(f, vec3(1)) / 6);
    const vec3 one = named("one", saturate(rank - 1)), two = named("two", saturate(rank));
    const auto height = function("simplex_corner(corner, way)", [](vec3 corner, vec3 way) {
        const Float near = named("near", max(0.5 - dot(way, way), 0));
        const Float cube = named("cube", near * near * near);
        const vec4 linear = named("linear", gradient_corner(hash(corner), way));
        return vec4(cube * (near * linear.xyz() - 8 * linear.w() * way), cube * near * linear.w());
    });
    const Float unskew = named("unskew // 1 / 6: a step of the lattice, per axis", Float(1.0 / 6));
    const Float two_unskew = named("two_unskew // of two steps", Float(1.0 / 3));
    return (height(cell, way) + height(cell + one, way - one + unskew) +
            height(cell + two, way - two + two_unskew) + height(cell + 1, way - 0.5)) *
           76;
}

Noise noise_function(Basis basis, int seed) {
    const auto with_seed = [seed](vec4 (*noise)(vec3, int)) {
        return [=](vec3 p) { return noise(p, seed); };
    };
    switch (basis) {
        case Basis::gradient:
            return {function("gradient_noise(p)", with_seed(gradient_noise))};
        case Basis::simplex:
            return {function("simplex_noise(p)", with_seed(simplex))};
        default:
            return {function("value_noise(p)", with_seed(value_noise))};
    }
}

// Measured.
double slope_variance(Basis basis) {
    if (basis == Basis::simplex) return 2.98;
    return basis == Basis::value ? 0.587 : 0.497;
}

Float lost_octaves(const Fractal& fractal, Float width) {
    const auto body = [](Float width, Float scale, Int octaves, Float lacunarity, Float gain) {
        using State = std::tuple<Int, Float, Float, Float, Float>;
        const auto add = [&](Int k, Float frequency, Float weight, Float total, Float lost) {
            const Float slope = frequency * weight;
            return std::tuple{k < octaves,
                              k + 1,
                              frequency * lacunarity,
                              weight * gain,
                              total + weight,
                              lost + slope * slope * lost_share(fade(width, frequency))};
        };
        const auto [k, frequency, weight, total, lost] =
            loop("octaves(k, frequency, weight, total, lost)", most_octaves,
                 State{0, scale, 1, 0, 0}, add);
        return lost / (total * total);
    };
    return function("lost_octaves(width, scale, octaves, lacunarity, gain)", body)(
        width, fractal.scale, fractal.octaves, fractal.lacunarity, fractal.gain);
}

Float fbm(const Fractal& fractal, Basis basis) {
    const Noise noise = noise_function(basis, fractal.seed);
    return mean_of_octaves("fbm", fractal, slope_variance(basis),
                           [&](const Octave& at) { return noise(at.p) * at.fade; });
}

// One octave.
static auto single(Basis basis, vec3 point, Float scale, int seed, Float amplitude) {
    const Noise noise = noise_function(basis, seed);
    const auto filtered =
        function("filtered_noise(point, width, scale)", [&](vec3 point, Float width, Float scale) {
            return noise(point * scale) * fade(width, scale);
        });
    const Float width = footprint(point);
    const Float lost = slope_variance(basis) * lost_share(fade(width, scale));
    const Float value = filtered(point, width, scale) + lost_slope(point * scale, lost);
    return relief_of(value, amplitude);
}

static constinit Node noise_list[] = {
    relief(with_octaves(
               noise_in_space(
                   "gradient_noise", "Gradient noise",
                   "Smooth random relief in space: octaves of Perlin noise, each finer and weaker "
                   "than the one before.",
                   4))
               .count("seed", 0, 0, 65535, seed_doc),
           0.02, "The noise, about -1 to 1, mostly within -0.5 to 0.5")
        .body([](vec3 point, Float scale, int octaves, Float lacunarity, Float gain, int seed,
                 Float amplitude) {
            const Fractal fractal{point, scale, octaves, lacunarity, gain, seed};
            return relief_of(fbm(fractal, Basis::gradient), amplitude);
        }),

    relief(noise_in_space("simplex_noise", "Simplex noise",
                          "Smooth random relief in space without the lattice's directions: one "
                          "octave of simplex noise.",
                          4)
               .count("seed", 0, 0, 65535, seed_doc),
           0.02, "The noise, about -1 to 1")
        .body([](vec3 point, Float scale, int seed, Float amplitude) {
            return single(Basis::simplex, point, scale, seed, amplitude);
        }),

    relief(
        noise_in_space("value_noise", "Value noise",
                       "Soft random blotches in space: a random number in each corner of a cell, "
                       "joined smoothly.",
                       4)
            .count("seed", 0, 0, 65535, seed_doc),
        0.02, "The noise, -1 to 1")
        .body([](vec3 point, Float scale, int seed, Float amplitude) {
            return single(Basis::value, point, scale, seed, amplitude);
        })};
constinit std::span<Node> noise_nodes = noise_list;

}  // namespace wrinkle::nodes
