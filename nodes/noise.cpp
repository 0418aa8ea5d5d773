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

static vec3 noise_direction(vec3 corner) {
    const auto direction = function("noise_direction(corner)", [](vec3 corner) {
        const Uint bits = hash(Int(corner.x()), Int(corner.y()), Int(corner.z()));
        const Uint none = ((bits >> 8u) * 3u) >> 24u;
        const Uint place = (none * 4u + (bits & 3u)) * 2u;
        const auto component = [&](unsigned k) {
            return Float((Uint(directions(k)) >> place) & 3u);
        };
        return vec3(component(0), component(1), component(2)) - 1;
    });
    return direction(corner);
}

static Float height_of(const vec4& corner) {
    return corner.w();
}
static Float height_of(const Float& corner) {
    return corner;
}

// Interpolates the eight corners of the cell around p by Perlin's quintic and returns (slope,
// height). corner(at, way) returns (slope, height) of the corner `at` at the position at + way, or
// only a height.
template <class Corner>
static vec4 lattice(vec3 p, Corner corner) {
    const vec3 low = floor(p), high = low + 1, from = p - low, back = from - 1;
    const vec3 t = from * from * from * (from * (from * 6 - vec3(15)) + vec3(10));
    const vec3 steepness = 30 * from * from * back * back;
    const auto pick = [](vec3 a, vec3 b, int x, int y, int z) {
        return vec3(x ? b.x() : a.x(), y ? b.y() : a.y(), z ? b.z() : a.z());
    };
    const auto at = [&](int x, int y, int z) {
        return corner(pick(low, high, x, y, z), pick(from, back, x, y, z));
    };
    const auto c000 = at(0, 0, 0), c100 = at(1, 0, 0), c010 = at(0, 1, 0), c110 = at(1, 1, 0);
    const auto c001 = at(0, 0, 1), c101 = at(1, 0, 1), c011 = at(0, 1, 1), c111 = at(1, 1, 1);
    const auto c00 = mix(c000, c100, t.x()), c10 = mix(c010, c110, t.x());
    const auto c01 = mix(c001, c101, t.x()), c11 = mix(c011, c111, t.x());
    const auto c0 = mix(c00, c10, t.y()), c1 = mix(c01, c11, t.y());
    const auto joined = mix(c0, c1, t.z());
    const auto rise = [](const auto& a, const auto& b) { return height_of(b) - height_of(a); };
    const vec3 across(mix(mix(rise(c000, c100), rise(c010, c110), t.y()),
                          mix(rise(c001, c101), rise(c011, c111), t.y()), t.z()),
                      mix(rise(c00, c10), rise(c01, c11), t.z()), rise(c0, c1));
    if constexpr (std::is_same_v<decltype(joined), const Float>)
        return {steepness * across, joined};
    else
        return {joined.xyz() + steepness * across, joined.w()};
}

// Sums the four corners of a simplex in the skewed lattice: the cell's corner, one step along the
// greatest component, one more along the next, and the opposite corner. Returns (slope, height).
static vec4 simplex(vec3 p) {
    const vec3 skewed = p + dot(p, vec3(1)) * (1.0 / 3);
    const vec3 cell = floor(skewed);
    const vec3 f = skewed - cell;
    const Float xy(f.x() >= f.y()), xz(f.x() >= f.z()), yz(f.y() >= f.z());
    const vec3 rank(xy + xz, 1 - xy + yz, 2 - xz - yz);
    const vec3 way = f - dot(f, vec3(1)) * (1.0 / 6);
    const vec3 one = saturate(rank - 1), two = saturate(rank);
    const auto corner = function("simplex_corner(corner, from)", [](vec3 corner, vec3 from) {
        const Float near = max(0.5 - dot(from, from), 0), cube = near * near * near;
        const vec3 slope = noise_direction(corner);
        const Float height = dot(slope, from);
        return vec4(cube * (near * slope - 8 * height * from), cube * near * height);
    });
    return (corner(cell, way) + corner(cell + one, way - one + 1.0 / 6) +
            corner(cell + two, way - two + 1.0 / 3) + corner(cell + 1, way - 0.5)) *
           76;
}

static vec4 gradient_noise(vec3 p) {
    const auto corner = function("gradient_corner(corner, way)", [](vec3 corner, vec3 way) {
        const vec3 slope = noise_direction(corner);
        return vec4(slope, dot(slope, way));
    });
    return lattice(p, corner);
}

static vec4 value_noise(vec3 p) {
    const auto value = function("value_corner(corner)", [](vec3 corner) {
        const Uint bits = hash(Int(corner.x()), Int(corner.y()), Int(corner.z()));
        return unit_float(bits) * 2 - 1;
    });
    return lattice(p, [&](vec3 corner, vec3) { return value(corner); });
}

Noise noise_function(Basis basis) {
    switch (basis) {
        case Basis::gradient:
            return {function("gradient_noise(p)", gradient_noise)};
        case Basis::simplex:
            return {function("simplex_noise(p)", simplex)};
        default:
            return {function("value_noise(p)", value_noise)};
    }
}

Float fbm(const Fractal& fractal, Basis basis) {
    const Noise noise = noise_function(basis);
    return mean_of_octaves("fbm", fractal,
                           [&](const Octave& at) { return noise(at.p) * fade(at.footprint); });
}

// One octave.
static auto single(Basis basis, vec3 point, Float scale, Float amplitude) {
    const Noise noise = noise_function(basis);
    const auto filtered = function("filtered_noise(p, width)",
                                   [&](vec3 p, Float width) { return noise(p) * fade(width); });
    return relief_of(filtered(point * scale, footprint(point, scale)), amplitude);
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
            const Fractal fractal{point, scale, octaves, lacunarity, gain};
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
