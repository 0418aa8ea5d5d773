// Noises on unit cells of space: functions of the generated code, which nodes call at any scale.
#pragma once

#include <vector>

#include "wrinkle/node.h"

namespace wrinkle::nodes {

// A height and its slope in separate functions: if only the bump is used, only the slope is
// computed. The call operator returns the height with that slope as its derivative.
template <class... More>
struct Sloped {
    sdk::Function<sdk::Float, std::tuple<sdk::vec3, More...>> height;
    sdk::Function<sdk::vec3, std::tuple<sdk::vec3, More...>> slope;

    sdk::Float operator()(sdk::vec3 p, More... more) const {
        return sdk::with_slope(height(p, more...), p, slope(p, more...));
    }
};
using Noise = Sloped<>;

// All have mean 0 and range [-1, 1], which they may exceed by a few percent.
//   gradient  K. Perlin 2002 on hashed lattice points: C2, 0 at lattice points
//   simplex   K. Perlin 2001 in the form of S. Gustavson 2005, with a kernel that ends at the
//             border of its simplices: C3
//   value     hashed numbers at lattice points, joined by the same quintic: C2
enum class Basis { gradient, simplex, value };
inline constexpr const char* basis_names[] = {"gradient", "simplex", "value"};
Noise noise_function(Basis basis);

// The layer that a fractal sums: a function of the generated code of a position and the pixel's
// footprint there.
using Layer = Sloped<sdk::Float>;

// Octaves of a layer: each `lacunarity` times finer than the one before and `gain` times as strong.
// Octave k is read at point * lacunarity^k + k * (19.19, 7.43, 31.71).
struct Fractal {
    sdk::vec3 point;  // in cells of the first octave
    int octaves;
    sdk::Float lacunarity, gain;
};
struct Octave {
    sdk::Float height, weight;
};
std::vector<Octave> octaves_of(const Fractal& fractal, const Layer& layer);
// Returns the sum of heights times weights, divided by the sum of weights: the range of one layer.
sdk::Float weighted_mean(const std::vector<Octave>& octaves);

// Fractional Brownian motion: the weighted mean of octaves of noise, each fading to 0.
sdk::Float fbm(const Fractal& fractal, Basis basis);

// The inputs of a fractal after point and scale.
template <class Declaration>
constexpr auto with_octaves(const Declaration& declaration) {
    return declaration.count("octaves", 4, 1, 8, "How many layers are added")
        .template in<sdk::Float>("lacunarity", 2, "How much finer each octave is",
                                 sdk::slider(1.5, 3), sdk::limits(1, 3), sdk::unit("x"))
        .template in<sdk::Float>("gain", 0.5,
                                 "How strong each octave is, relative to the one before",
                                 sdk::slider(0, 1), sdk::limits(0, 1));
}

}  // namespace wrinkle::nodes
