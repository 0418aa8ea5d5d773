// Sums of sines on a uv set.
#include <span>

#include "nodes/footprint.h"
#include "nodes/random.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

struct Waves {
    vec2 uv;
    Float scale;
    Choice shape;
    int count;
    Float direction, spread, lacunarity, gain, phase;
    int seed;
    Float amplitude;
};

static constexpr int most_waves = 8;

// Returns a pseudo-random number of a wave in [0, 1), the same in every graph.
static Float number(const Waves& in, int wave, int which) {
    return unit_float(hash(Int(wave + most_waves * in.seed), Int(which)));
}

static vec2 direction_of(const Waves& in, int wave) {
    const Float angle = radians(in.direction + in.spread * (number(in, wave, 0) - 0.5));
    return {cos(angle), sin(angle)};
}

// Both take 2 pi times a fraction, since sines of large angles are inexact.
static Float plane_wave(const Waves& in, vec2 p, int wave) {
    const Float along = dot(p, direction_of(in, wave));
    return sin(fract(along + number(in, wave, 1) - in.phase) * two_pi());
}
// A cosine, unlike a sine, is smooth at the centre of the rings.
static Float ring_wave(const Waves& in, vec2 p, Float frequency, int wave) {
    const vec2 centre(number(in, wave, 0), number(in, wave, 1));
    return cos(fract(length(p - centre * frequency) - in.phase) * two_pi());
}

// Returns the covariance of the slopes of a wave of amplitude 1 and wavelength 2 pi.
static vec3 lost_wave(const Waves& in, int wave) {
    if (in.shape != 0) return {0.25, 0.25, 0};
    const vec2 d = direction_of(in, wave);
    return 0.5 * vec3(d * d, d.x() * d.y());
}

static constinit Node waves_list[] = {
    relief(pattern_on_uv("waves", "Waves",
                         "Ripples or water on a uv set: a sum of sines, straight ones or rings.",
                         "scale", 4, "Periods of the first wave per uv unit")
               .choice("shape", {"straight", "rings"},
                       "Straight fronts, or rings around random places of the unit square")
               .count("count", 4, 1, most_waves, "How many waves are added")
               .in<Float>("direction", 0, "Where straight waves go, anticlockwise from u",
                          slider(-180, 180), unit("deg"))
               .in<Float>("spread", 120, "How far straight waves turn away from it in all",
                          slider(0, 360), unit("deg"))
               .in<Float>("lacunarity", 1.3, "How much shorter each wave is", slider(1, 2),
                          limits(1, 2), unit("x"))
               .in<Float>("gain", 0.8, "How strong each wave is, relative to the one before",
                          slider(0, 1), limits(0, 1))
               .in<Float>("phase", 0, "How far the waves have gone, in periods", slider(0, 1))
               .count("seed", 0, 0, 65535, seed_doc),
           0.01, "The sum, -1 to 1")
        .body([](Waves in) {
            Float sum = 0, total = 0, frequency = in.scale, weight = 1;
            vec3 lost(0);
            for (int wave = 0; wave < in.count; ++wave) {
                const vec2 p = in.uv * frequency;
                const Float height =
                    in.shape == 0 ? plane_wave(in, p, wave) : ring_wave(in, p, frequency, wave);
                const Float near = fade(footprint(p)), slope = weight * frequency * two_pi();
                sum += height * (weight * near);
                lost += lost_wave(in, wave) * (slope * slope * lost_share(near));
                total += weight;
                frequency *= in.lacunarity;
                weight *= in.gain;
            }
            const Float value = (sum + lost_slope(in.uv, lost)) / total;
            return relief_of(value, in.amplitude);
        })};
constinit std::span<Node> waves_nodes = waves_list;

}  // namespace wrinkle::nodes
