// Smooth random relief in space. Random numbers come from integer hashes, so they are the same on
// every target.
#include <span>

#include "nodes/noise.h"

#include "nodes/footprint.h"
#include "nodes/random.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

// Returns (slope, height) of a corner of the lattice at the position corner + way: one of the
// twelve directions to the edges of a cube (K. Perlin 2002), of length sqrt(2), and its product
// with way.
static vec4 gradient_corner(vec3 corner, vec3 way) {
    const auto from = function("gradient_corner(corner, way)", [](vec3 corner, vec3 way) {
        const Uint bits = named("bits", hash(corner));
        const Uint axis = named("axis", ((bits >> 8u) * 3u) >> 24u);  // where the direction is 0
        const Float a = named("a", 1 - 2 * Float(bits & 1u)), b = named("b", 1 - Float(bits & 2u));
        const Float first = named("first", select(axis == 0u, a, 0));
        const Float last = named("last", select(axis == 2u, b, 0));
        const vec3 slope(named("x", a - first), named("y", first + last), named("z", b - last));
        return vec4(slope, dot(slope, way));
    });
    return from(corner, way);
}

// A position in its cell of the lattice, Perlin's quintic of it by component, and its derivative.
struct Cell {
    vec3 corner, way, t, t_slope;
};
static Cell cell_of(vec3 p, int seed) {
    const vec3 corner = named("cell", floor(p)), way = named("f", p - corner);
    const vec3 back = named("back", way - 1);
    return {seeded_cell(corner, seed), way,
            named("t", way * way * way * (way * (way * 6 - vec3(15)) + vec3(10))),
            named("t_slope", 30 * way * way * back * back)};
}

// Interpolates (slope, height) of the eight corners: along x, then y, then z. Each step adds the
// slope along its axis.
static vec4 gradient_noise(vec3 p, int seed) {
    const auto edge =
        function("gradient_edge(corner, way, t, t_slope)",
                 [](vec3 corner, vec3 way, Float t, Float t_slope) {
                     const vec3 x(1, 0, 0);
                     const vec4 a = named("a", gradient_corner(corner, way));
                     const vec4 b = named("b", gradient_corner(corner + x, way - x));
                     return named("mixed", mix(a, b, t)) + vec4(t_slope * (b.w() - a.w()), 0, 0, 0);
                 });
    const Cell cell = cell_of(p, seed);
    const auto along_x = [&](const char* name, vec3 at) {
        return named(name, edge(cell.corner + at, cell.way - at, cell.t.x(), cell.t_slope.x()));
    };
    const vec4 a = along_x("a", vec3(0)), b = along_x("b", {0, 1, 0});
    const vec4 c = along_x("c", {0, 0, 1}), d = along_x("d", {0, 1, 1});
    const vec4 y(0, cell.t_slope.y(), 0, 0), z(0, 0, cell.t_slope.z(), 0);
    const vec4 low = named("low", named("ab", mix(a, b, cell.t.y())) + y * (b.w() - a.w()));
    const vec4 high = named("high", named("cd", mix(c, d, cell.t.y())) + y * (d.w() - c.w()));
    return named("joined", mix(low, high, cell.t.z())) + z * (high.w() - low.w());
}

// The same for corners that have only a height: each step makes one component of the slope.
static vec4 value_noise(vec3 p, int seed) {
    const auto edge =
        function("value_edge(corner, t, t_slope)", [](vec3 corner, Float t, Float t_slope) {
            const Float a = named("a", unit_float(hash(corner)) * 2 - 1);
            const Float b = named("b", unit_float(hash(corner + vec3(1, 0, 0))) * 2 - 1);
            return vec2(t_slope * (b - a), mix(a, b, t));
        });
    const Cell cell = cell_of(p, seed);
    const auto along_x = [&](const char* name, vec3 at) {
        return named(name, edge(cell.corner + at, cell.t.x(), cell.t_slope.x()));
    };
    const auto along_y = [&](vec2 a, vec2 b) {
        const vec2 mixed = mix(a, b, cell.t.y());
        return vec3(mixed.x(), cell.t_slope.y() * (b.y() - a.y()), mixed.y());
    };
    const vec3 low = named("low", along_y(along_x("a", vec3(0)), along_x("b", {0, 1, 0})));
    const vec3 high = named("high", along_y(along_x("c", {0, 0, 1}), along_x("d", {0, 1, 1})));
    const vec3 mixed = named("mixed", mix(low, high, cell.t.z()));
    return vec4(mixed.xy(), vec2(cell.t_slope.z() * (high.z() - low.z()), mixed.z()));
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
        const vec4 linear = named("linear", gradient_corner(corner, way));
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
