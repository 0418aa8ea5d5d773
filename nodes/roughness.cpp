// Roughness from bumps that are finer than a pixel, by the variance of their slopes.
#include <span>

#include "nodes/footprint.h"
#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

struct SlopeMomentsMap {
    Image slopes, moments;
    vec2 uv;
    Float strength;
    PerLength per;
    bool flip_u, flip_v;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

// LEAN mapping: covariance = second moments - products of the means.
static vec2 slope_with_moments(const SlopeMomentsMap& in) {
    const vec2 mean = in.slopes.sample(in.uv).xy();
    const vec3 moments = in.moments.sample(in.uv).xyz();
    const Float texels = footprint(in.uv * in.slopes.size());
    const Float minified = clamp(log2(max(texels, 1)), 0, 1);
    const vec3 covariance(max(moments.x() - mean.x() * mean.x(), 0),
                          max(moments.y() - mean.y() * mean.y(), 0),
                          moments.z() - mean.x() * mean.y());
    return with_covariance(mean, covariance * minified);
}

static constinit Node roughness_list[] = {
    // A GGX lobe of width alpha corresponds to a slope variance of alpha^2 / 2 per axis. Variances
    // add; the sum over both axes is used here.
    gradient_family(
        "bump_roughness", "Roughness of bump",
        "Keeps a highlight as wide as the bump makes it where the bump is too fine for the "
        "picture: the slopes that mips and filters leave out become roughness. Of normal maps read "
        "in three channels, slope moments maps, noises and most patterns; not of height maps.")
        .in<Gradient>("gradient", "The bump that is resolved, all of it")
        .in<Float>("roughness", 0.5, "Of the surface by itself, perceptual: its square is alpha",
                   slider(0, 1), limits(0, 1))
        .in<Float>("amount", 1, "Factor of the variance: 0 leaves the roughness unchanged",
                   slider(0, 2), limits(0, 4), unit("x"))
        .out<Float>("roughness", "Perceptual roughness, 0 to 1")
        .out<Float>("variance", "Of the unit normal within a pixel, both ways added")
        .body([](Gradient g, Float roughness, Float amount) {
            const Float variance = normal_variance(g);
            const Float alpha = roughness * roughness;
            const Float wider = min(alpha * alpha + variance * amount, 1);
            return std::tuple{sqrt(sqrt(wider)), variance};
        }),

    slope_ports(
        image_family(
            "slope_moments_map", "Slope moments map",
            "A bump from a picture of slopes, with a second picture of their squares and product, "
            "so that `bump_roughness` knows exactly what the mips leave out (LEAN mapping). "
            "`wrinkle convert` makes both of a height or a normal map, --to derivative and --to "
            "moments.")
            .in<Image>("slopes", "Slopes dh/du in red and dh/dv in green", encoding("linear"))
            .in<Image>("moments",
                       "Of the same slopes: dh/du squared, dh/dv squared, and their product",
                       encoding("linear"))
            .in<vec2>("uv", surface::uv0, "Where to read both"))
        .body([](SlopeMomentsMap in) {
            return bump_of_slope(slope_with_moments(in), in.slopes, in);
        })};
constinit std::span<Node> roughness_nodes = roughness_list;

}  // namespace wrinkle::nodes
