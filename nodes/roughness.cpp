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

struct PrincipalAxis {
    vec3 direction;  // in which the variance is greatest, across the unit normal
    Float least, most;
};

// The eigenvectors of the covariance of the unit normal, by the half of the angle of its deviator.
static PrincipalAxis principal_axis(Gradient gradient) {
    const vec3 normal = resolve(gradient);
    const vec3 other = select(abs(normal.x()) < 0.6, vec3(1, 0, 0), vec3(0, 1, 0));
    const vec3 x = named("x", normalize(cross(normal, other)));
    const vec3 covariance = named("covariance", normal_covariance(gradient, x));
    const Float mean = 0.5 * (covariance.x() + covariance.y());
    const Float along = 0.5 * (covariance.x() - covariance.y());
    const Float radius = named("radius", length(vec2(along, covariance.z())));
    const Float cosine = named("cosine", select(radius > 0, along / radius, 1));
    const Float side = select(covariance.z() < 0, -1, 1);
    const vec3 y = cross(normal, x);
    const vec3 direction =
        x * sqrt(max(0.5 + 0.5 * cosine, 0)) + y * (side * sqrt(max(0.5 - 0.5 * cosine, 0)));
    return {direction, max(mean - radius, 0), mean + radius};
}

static constinit Node roughness_list[] = {
    // A GGX lobe of width alpha corresponds to a slope variance of alpha^2 / 2 per axis. Variances
    // add; the sum over both axes is used here.
    gradient_family(
        "bump_roughness", "Roughness of bump",
        "Keeps a highlight as wide as the bump makes it where the bump is too fine for the "
        "image: the slopes that mips and filters leave out become roughness. Of normal maps read "
        "in three channels, slope moments maps, noises and most patterns; not of height maps.")
        .in<Gradient>("gradient", "The bump that is resolved, all of it")
        .in<Float>("roughness", 0.5,
                   "Roughness of the surface itself, perceptual: its square is alpha", slider(0, 1),
                   limits(0, 1))
        .in<Float>("amount", 1, "Factor of the variance: 0 leaves the roughness unchanged",
                   slider(0, 2), limits(0, 4), unit("x"))
        .out<Float>("roughness", "Perceptual roughness, 0 to 1")
        .out<Float>("variance", "Variance of the unit normal within a pixel, both axes added")
        .out<Float>("anisotropy",
                    "How much wider the highlight is along the tangent, for the output "
                    "`specular_roughness_anisotropy`")
        .out<vec3>("tangent", "Where slopes vary most, in object space, for the output `tangent`")
        .body([](Gradient g, Float roughness, Float amount) {
            const Float variance = normal_variance(g);
            const Float alpha = roughness * roughness;
            const Float wider = min(alpha * alpha + variance * amount, 1);
            const auto [tangent, least, most] = principal_axis(g);
            const Float narrow = alpha * alpha + 2 * amount * least;
            const Float wide = alpha * alpha + 2 * amount * most;
            const Float anisotropy = 1 - sqrt(select(wide > 0, narrow / wide, 1));
            return std::tuple{sqrt(sqrt(wider)), variance, anisotropy, tangent};
        }),

    slope_ports(
        image_family(
            "slope_moments_map", "Slope moments map",
            "A bump from an image of slopes, with a second image of their squares and product, "
            "so that `bump_roughness` knows exactly what the mips leave out (LEAN mapping). "
            "`wrinkle convert` makes both of a height or a normal map, --to derivative and --to "
            "moments.")
            .in<Image>("slopes", "Slopes dh/du in red and dh/dv in green", encoding("linear"))
            .in<Image>(
                "moments",
                "Moments of the same slopes: dh/du squared, dh/dv squared, and their product",
                encoding("linear"))
            .in<vec2>("uv", surface::uv0, "Where to read both"))
        .body([](SlopeMomentsMap in) {
            return bump_of_slope(slope_with_moments(in), in.slopes, in);
        })};
constinit std::span<Node> roughness_nodes = roughness_list;

}  // namespace wrinkle::nodes
