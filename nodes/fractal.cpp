// Relief made of octaves of noise, each finer and weaker than the one before.
#include <span>

#include "nodes/footprint.h"
#include "nodes/noise.h"
#include "nodes/random.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

struct FractalNoise {
    vec3 point;
    Float scale;
    int octaves;
    Float lacunarity, gain;
    Basis basis;
    int seed;
    Float amplitude;

    Fractal fractal() const { return {point, scale, octaves, lacunarity, gain, seed}; }
};

static constexpr auto fractal(const char* id, const char* title, const char* doc) {
    return with_octaves(noise_in_space(id, title, doc, 3))
        .choice("basis", basis_names, "The noise that is added up")
        .count("seed", 0, 0, 65535, seed_doc);
}

// Measured: the spatial means of |noise| and (1 - |noise|)^2, to which octaves fade, and the slope
// variance per axis of an octave of ridges.
struct Means {
    double absolute, ridge, ridge_slope;
};
static Means means_of(Basis basis) {
    if (basis == Basis::simplex) return {0.311, 0.530, 6.08};
    if (basis == Basis::value) return {0.330, 0.500, 1.16};
    return {0.220, 0.633, 1.45};
}

// The sum of |noise| over octaves, 0 to about 1.
static Float billows(const Fractal& fractal, Basis basis) {
    const Noise noise = noise_function(basis, fractal.seed);
    return mean_of_octaves("billows", fractal, slope_variance(basis), [&](const Octave& at) {
        return mix(means_of(basis).absolute, abs(noise(at.p)), at.fade);
    });
}

// F. K. Musgrave's ridged multifractal: each octave is multiplied by twice the previous one,
// saturated.
static Float ridges(const Fractal& fractal, Basis basis) {
    const Noise noise = noise_function(basis, fractal.seed);
    return mean_of_octaves("ridges", fractal, means_of(basis).ridge_slope, [&](const Octave& at) {
        const Float fold = 1 - abs(noise(at.p));
        return mix(means_of(basis).ridge, fold * fold, at.fade) * saturate(at.previous * 2);
    });
}

struct Dents {
    vec3 point;
    Float scale;
    int octaves;
    Float lacunarity, gain, threshold, power;
    int seed;
    Float amplitude;
};

static constinit Node fractal_list[] = {
    relief(fractal("fbm", "Fractal noise",
                   "Natural roughness in space: fractional Brownian motion, a sum of noise "
                   "octaves."),
           0.04, "The sum, about -1 to 1, mostly within -0.5 to 0.5")
        .body([](FractalNoise in) { return relief_of(fbm(in.fractal(), in.basis), in.amplitude); }),

    relief(fractal("turbulence", "Turbulence",
                   "Billows that meet in sharp creases: a sum of octaves of the absolute "
                   "value of noise."),
           0.06, "The sum, 0 to about 1, mostly below 0.5")
        .body([](FractalNoise in) {
            return relief_of(billows(in.fractal(), in.basis), in.amplitude);
        }),

    relief(fractal("ridged", "Ridged noise",
                   "Mountain ridges: octaves of folded noise, finer ones on the ridges only."),
           0.06, "The sum, 0 to 1, 1 on the ridges")
        .body([](FractalNoise in) {
            return relief_of(ridges(in.fractal(), in.basis), in.amplitude);
        }),

    relief(
        with_octaves(
            noise_in_space(
                "dents", "Dents",
                "Hammered metal: a power of what turbulence has above a threshold, pressed in.", 3))
            .in<Float>("threshold", 0.2, "Turbulence up to this is left alone", slider(0, 0.6),
                       limits(0, 0.99))
            .in<Float>("power", 1.5, "Higher makes dents steeper and their rims softer",
                       slider(1, 4), limits(1, 16))
            .count("seed", 0, 0, 65535, seed_doc),
        0.1, "How deep, 0 to -1")
        .body([](Dents in) {
            const Fractal fractal{in.point, in.scale, in.octaves, in.lacunarity, in.gain, in.seed};
            const Float over = billows(fractal, Basis::gradient) - in.threshold;
            return relief_of(-pow(saturate(over / (1 - in.threshold)), in.power), in.amplitude);
        })};
constinit std::span<Node> fractal_nodes = fractal_list;

}  // namespace wrinkle::nodes
