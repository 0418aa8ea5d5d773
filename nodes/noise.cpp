// Smooth random relief in space. Random numbers come from integer hashes, so they are the same on
// every target.
#include <span>

#include "nodes/noise.h"

#include "nodes/footprint.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

// The twelve directions to the edges of a cube (K. Perlin 2002), of length sqrt(2), ordered by the
// axis on which they are 0, then by the signs of the other two components. Returns one component of
// all directions, plus 1, packed in two bits each.
static constexpr unsigned directions(unsigned component) {
    unsigned packed = 0;
    for (unsigned which = 0; which < 12; ++which) {
        const unsigned none = which / 4, first = none == 0 ? 1 : 0;
        const bool negative = (which & (component == first ? 1u : 2u)) != 0;
        packed |= (component == none ? 1u : negative ? 0u : 2u) << (2 * which);
    }
    return packed;
}

static vec3 direction_at(Int x, Int y, Int z) {
    const Uint bits = hash(x, y, z);
    const Uint none = ((bits >> 8u) * 3u) >> 24u;
    const Uint place = (none * 4u + (bits & 3u)) * 2u;
    const auto component = [&](unsigned k) { return Float((Uint(directions(k)) >> place) & 3u); };
    return vec3(component(0), component(1), component(2)) - 1;
}

static Float value_at(Int x, Int y, Int z) {
    return unit_float(hash(x, y, z)) * 2 - 1;
}

// A height at a position and its slope there. If one is unused, it is not in the generated code.
struct Rise {
    Float height;
    vec3 slope;
};

static Rise mix(const Rise& a, const Rise& b, Float t) {
    return {mix(a.height, b.height, t), mix(a.slope, b.slope, t)};
}

// Interpolates the eight corners of the cell around p by Perlin's quintic. corner(x, y, z, way)
// returns the Rise of a lattice point at the offset `way` from it.
template <class Corner>
static Rise lattice(vec3 p, Corner corner) {
    const vec3 cell = floor(p), f = p - cell;
    const Int x(cell.x()), y(cell.y()), z(cell.z());
    const vec3 t = f * f * f * (f * (f * 6 - vec3(15)) + vec3(10));
    const vec3 steepness = 30 * f * f * (f - 1) * (f - 1);
    const auto at = [&](int dx, int dy, int dz) {
        return corner(x + dx, y + dy, z + dz, f - vec3(dx, dy, dz));
    };
    const auto row = [&](int dy, int dz) { return mix(at(0, dy, dz), at(1, dy, dz), t.x()); };
    const auto along_x = [&](int dy, int dz) {
        return at(1, dy, dz).height - at(0, dy, dz).height;
    };
    const auto along_y = [&](int dz) { return row(1, dz).height - row(0, dz).height; };
    const Rise near = mix(row(0, 0), row(1, 0), t.y()), far = mix(row(0, 1), row(1, 1), t.y());
    const Rise joined = mix(near, far, t.z());
    const vec3 across(mix(mix(along_x(0, 0), along_x(1, 0), t.y()),
                          mix(along_x(0, 1), along_x(1, 1), t.y()), t.z()),
                      mix(along_y(0), along_y(1), t.z()), far.height - near.height);
    return {joined.height, joined.slope + steepness * across};
}

// Sums the four corners of a simplex in the skewed lattice: the cell's corner, one step along the
// greatest component, one more along the next, and the opposite corner. direction(x, y, z) returns
// the gradient of a lattice point.
template <class Direction>
static Rise simplex(vec3 p, Direction direction) {
    const vec3 skewed = p + dot(p, vec3(1)) * (1.0 / 3);
    const vec3 cell = floor(skewed);
    const vec3 f = skewed - cell;
    const Float xy(f.x() >= f.y()), xz(f.x() >= f.z()), yz(f.y() >= f.z());
    const vec3 rank(xy + xz, 1 - xy + yz, 2 - xz - yz);
    const vec3 way = f - dot(f, vec3(1)) * (1.0 / 6);
    const vec3 one = saturate(rank - 1), two = saturate(rank);
    Rise sum{0, vec3(0)};
    const auto add = [&](vec3 corner, vec3 from) {
        const Float near = max(0.5 - dot(from, from), 0), cube = near * near * near;
        const vec3 slope = direction(Int(corner.x()), Int(corner.y()), Int(corner.z()));
        const Float height = dot(slope, from);
        sum.height += cube * near * height;
        sum.slope += cube * (near * slope - 8 * height * from);
    };
    add(cell, way);
    add(cell + one, way - one + 1.0 / 6);
    add(cell + two, way - two + 1.0 / 3);
    add(cell + 1, way - 0.5);
    return {sum.height * 76, sum.slope * 76};
}

// Returns rise(p) as two functions of the generated code, for height and slope.
template <class At>
static Noise noise_of(const char* height, const char* slope, At rise) {
    return {function(height, [&](vec3 p) { return rise(p).height; }),
            function(slope, [&](vec3 p) { return rise(p).slope; })};
}

Noise noise_function(Basis basis) {
    if (basis == Basis::value) {
        const auto value = function("value_corner", value_at);
        const auto corner = [&](Int x, Int y, Int z, vec3) {
            return Rise{value(x, y, z), vec3(0)};
        };
        return noise_of("value_noise", "value_noise_slope",
                        [&](vec3 p) { return lattice(p, corner); });
    }
    const auto direction = function("noise_direction", direction_at);
    if (basis == Basis::simplex)
        return noise_of("simplex_noise", "simplex_noise_slope",
                        [&](vec3 p) { return simplex(p, direction); });
    const auto corner = [&](Int x, Int y, Int z, vec3 way) {
        const vec3 slope = direction(x, y, z);
        return Rise{dot(slope, way), slope};
    };
    return noise_of("gradient_noise", "gradient_noise_slope",
                    [&](vec3 p) { return lattice(p, corner); });
}

std::vector<Octave> octaves_of(const Fractal& fractal, const Layer& layer) {
    vec3 p = fractal.point;
    Float reach = footprint(p), weight = 1;
    std::vector<Octave> octaves{{layer(p, reach), weight}};
    for (int octave = 1; octave < fractal.octaves; ++octave) {
        p *= fractal.lacunarity;
        // Without the offset, every octave would be 0 at the origin. It is not scaled with p, which
        // would lose precision.
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
    const Layer layer{
        function("noise_octave", [&](vec3 p, Float w) { return noise.height(p) * fade(w); }),
        function("noise_octave_slope", [&](vec3 p, Float w) { return noise.slope(p) * fade(w); })};
    return weighted_mean(octaves_of(fractal, layer));
}

static auto single(Basis basis, vec3 point, Float scale, Float amplitude) {
    const vec3 p = point * scale;
    return relief_of(noise_function(basis)(p) * fade(footprint(p)), amplitude);
}

static constinit Node noise_list[] = {
    relief(with_octaves(noise_in_space(
               "gradient_noise", "Gradient noise",
               "Smooth random relief in space: octaves of Perlin noise, each finer and weaker "
               "than the one before.",
               4)),
           0.02, "The noise, about -1 to 1, mostly within -0.5 to 0.5")
        .body([](vec3 point, Float scale, int octaves, Float lacunarity, Float gain,
                 Float amplitude) {
            const Fractal fractal{point * scale, octaves, lacunarity, gain};
            return relief_of(fbm(fractal, Basis::gradient), amplitude);
        }),

    relief(noise_in_space("simplex_noise", "Simplex noise",
                          "Smooth random relief in space without the lattice's directions: one "
                          "octave of simplex noise.",
                          4),
           0.02, "The noise, about -1 to 1")
        .body([](vec3 point, Float scale, Float amplitude) {
            return single(Basis::simplex, point, scale, amplitude);
        }),

    relief(
        noise_in_space("value_noise", "Value noise",
                       "Soft random blotches in space: a random number in each corner of a cell, "
                       "joined smoothly.",
                       4),
        0.02, "The noise, -1 to 1")
        .body([](vec3 point, Float scale, Float amplitude) {
            return single(Basis::value, point, scale, amplitude);
        })};
constinit std::span<Node> noise_nodes = noise_list;

}  // namespace wrinkle::nodes
