// Noises on unit cells of space: functions of the generated code, which nodes call at any scale.
#pragma once

#include <string>
#include <tuple>

#include "nodes/footprint.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {

// A function of the generated code that returns (slope, height). The call operator returns the
// height with that slope as its derivative.
struct Noise {
    sdk::Function<sdk::vec4, std::tuple<sdk::vec3>> slope_and_height;

    sdk::Float operator()(sdk::vec3 p) const {
        const sdk::vec4 at = sdk::named("noise", slope_and_height(p));
        return sdk::with_slope(at.w(), p, at.xyz());
    }
};

// All have mean 0 and range [-1, 1], which they may exceed by a few percent.
//   gradient  K. Perlin 2002 on hashed lattice points: C2, 0 at lattice points
//   simplex   K. Perlin 2001 in the form of S. Gustavson 2005, with a kernel that ends at the
//             border of its simplices: C3
//   value     hashed numbers at lattice points, joined by the same quintic: C2
enum class Basis { gradient, simplex, value };
inline constexpr const char* basis_names[] = {"gradient", "simplex", "value"};
// Each seed gives other random numbers (random.h).
Noise noise_function(Basis basis, int seed);
double slope_variance(Basis basis);  // mean square of one component of the slope

inline constexpr int most_octaves = 8;

// Octaves of a noise, each `lacunarity` times finer than the one before and `gain` times as strong.
// Octave k is read at point * scale * lacunarity^k + k * (19.19, 7.43, 31.71).
struct Fractal {
    sdk::vec3 point;
    sdk::Float scale;  // cells of the first octave per length unit
    int octaves;
    sdk::Float lacunarity, gain;
    int seed;
};

// A position in an octave, how much of it is visible (footprint.h), and the height of the octave
// before, which is 1 for the first.
struct Octave {
    sdk::vec3 p;
    sdk::Float fade, previous;
};

// Returns the slope variance per axis that the fades remove from the weighted mean of octaves, in
// units of the slope variance of one octave on unit cells. `width` is the footprint of the point.
sdk::Float lost_octaves(const Fractal& fractal, sdk::Float width);

// Returns the weighted mean of height(Octave) over the octaves, in the range of one octave, from a
// function `name` of the generated code. `slope_variance` is that of one octave on unit cells, per
// axis.
template <class Height>
sdk::Float mean_of_octaves(const char* name, const Fractal& fractal, double slope_variance,
                           Height height) {
    using namespace sdk;
    const auto body = [&](vec3 point, Float width, Float scale, Int octaves, Float lacunarity,
                          Float gain) {
        using State = std::tuple<Int, Float, Float, Float, Float, Float>;
        const auto add = [&](Int k, Float frequency, Float weight, Float previous, Float total,
                             Float sum) {
            const vec3 offset =
                named("octave_offset // between octaves, in cells", vec3(19.19, 7.43, 31.71));
            // Without the offset, every octave would be 0 at the origin. It is not scaled, which
            // would lose precision.
            const vec3 p = named("p", point * frequency + offset * Float(k));
            const Float value = height(Octave{p, fade(width, frequency), previous});
            return std::tuple{k < octaves, k + 1,          frequency * lacunarity, weight * gain,
                              value,       total + weight, sum + value * weight};
        };
        const auto [k, frequency, weight, previous, total, sum] =
            loop("octaves(k, frequency, weight, previous, total, sum)", most_octaves,
                 State{0, scale, 1, 1, 0, 0}, add);
        return sum / total;
    };
    const std::string signature =
        name + std::string("(point, width, scale, octaves, lacunarity, gain)");
    const Float width = footprint(fractal.point);
    const Float mean = function(signature.c_str(), body)(
        fractal.point, width, fractal.scale, fractal.octaves, fractal.lacunarity, fractal.gain);
    return mean + lost_slope(fractal.point, lost_octaves(fractal, width) * slope_variance);
}

// Fractional Brownian motion: the weighted mean of octaves of noise, each fading to 0.
sdk::Float fbm(const Fractal& fractal, Basis basis);

// The inputs of a fractal after point and scale.
template <class Declaration>
constexpr auto with_octaves(const Declaration& declaration) {
    return declaration.count("octaves", 4, 1, most_octaves, "How many layers are added")
        .template in<sdk::Float>("lacunarity", 2, "How much finer each octave is",
                                 sdk::slider(1.5, 3), sdk::limits(1, 3), sdk::unit("x"))
        .template in<sdk::Float>("gain", 0.5,
                                 "How strong each octave is, relative to the one before",
                                 sdk::slider(0, 1), sdk::limits(0, 1));
}

}  // namespace wrinkle::nodes
