// Masks by the surface and by the eye: 0 to 1, with edges of at least a pixel.
#include <numbers>
#include <span>

#include "nodes/footprint.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto mask_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("mask");
}
template <class Declaration>
static constexpr auto with_angle(const Declaration& declaration, double angle, const char* doc) {
    return declaration
        .template in<Float>("angle", angle, doc, slider(0, 180), limits(0, 180), unit("deg"))
        .template in<Float>("softness", 20, "Width of the edge; at least a pixel", slider(0, 90),
                            limits(0, 360), unit("deg"));
}
template <class Declaration>
static constexpr auto seen_from(const Declaration& declaration) {
    return declaration.template in<Normal>("normal", surface::normal, "Unit normal in object space")
        .template in<vec3>("view", surface::view, "Unit direction to the eye, object space");
}

// A smooth step around `middle`, of at least a millionth.
static Float smooth_edge(Float x, Float middle, Float width) {
    const Float t = named("t", saturate((x - middle) / max(width, 1e-6) + 0.5));
    return t * t * (3 - 2 * t);
}

// 1 where a direction is within an angle of another one, by the cosine between them.
static Float within(Float cosine, Float angle, Float softness) {
    const auto edge_at = [&](Float degrees) { return cos(radians(clamp(degrees, 0, 180))); };
    const Float low = named("low", edge_at(angle + 0.5 * softness));
    const Float high = named("high", edge_at(angle - 0.5 * softness));
    const Float width = named("edge_width", max(high - low, box_width(cosine)));
    return smooth_edge(cosine, named("middle", 0.5 * (low + high)), width);
}

// The integral of saturate(t).
static Float ramp_integral(Float t) {
    const Float inside = saturate(t);
    return 0.5 * inside * inside + max(t - 1, 0);
}
// The mean of saturate over a box, which is at least 1/512: narrower ones only add rounding errors.
static Float saturate_mean(Float t, Float width) {
    const Float half = named("half_box", 0.5 * max(width, 1.0 / 512));
    const Float middle = named("middle", clamp(t, -half, 1 + half));
    return (ramp_integral(middle + half) - ramp_integral(middle - half)) / (2 * half);
}

// The part of unpolarized light that a smooth surface reflects; all of it beyond the critical angle
// of an ior below 1.
static Float dielectric_fresnel(Float cosine, Float ior) {
    const auto fresnel = function("dielectric_fresnel(c, ior)", [](Float c, Float ior) {
        const Float square = named("g_square", ior * ior - 1 + c * c);
        const Float g = named("g", sqrt(max(square, 0)));
        const Float across = named("across", divide(g - c, g + c));
        const Float along = named("along", divide(c * (g + c) - 1, c * (g - c) + 1));
        return select(square > 0, 0.5 * across * across * (1 + along * along), 1);
    });
    return fresnel(cosine, ior);
}

// Blender's blend as an exponent of the cosine: 0.5 is 1, 0 is 0, near 1 it grows without bound.
static Float facing_exponent(Float blend) {
    return select(blend < 0.5, 2 * blend, 0.5 / (1 - blend));
}

enum class FresnelModel { exact, power };

static constinit Node mask_list[] = {
    with_angle(
        mask_family("direction_mask", "Direction mask",
                    "Where a surface faces a direction: snow and dust from above, moss, rain.")
            .in<Normal>("normal", surface::normal, "Unit normal in object space")
            .in<vec3>("axis", {0, 1, 0}, "The direction in object space, any length"),
        45, "From the axis to the middle of the edge")
        .out<Float>("value", "1 where the normal is along the axis, 0 beyond the angle")
        .body([](vec3 normal, vec3 axis, Float angle, Float softness) {
            return within(named("cosine", dot(normal, normalize(axis))), angle, softness);
        }),

    with_angle(mask_family("slope_mask", "Slope mask",
                           "Where a bump is steep: rock on slopes, sand where it is flat. The mask "
                           "itself has slope 0.")
                   .in<Gradient>("gradient", "The bump to measure"),
               30, "Tilt in the middle of the edge")
        .out<Float>("value", "1 where the bump is steeper")
        .out<Float>("flat", "1 where it is flatter")
        .body([](Gradient gradient, Float angle, Float softness) {
            const vec3 slope = named("slope", detach(gradient.vector()));
            const Float flat =
                named("flat", within(1 / sqrt(1 + dot(slope, slope)), angle, softness));
            return std::tuple{1 - flat, flat};
        }),

    mask_family("height_mask", "Height mask",
                "Where a relief is high, with the slope of the relief: height_mix by it has the "
                "exact bump.")
        .in<Height>("height", 0, "In length units of object space")
        .in<Height>("low", 0,
                    "Height of value 0, in length units of object space; above `high`, the mask "
                    "selects low parts",
                    slider(-0.1, 0.1), unit("m"))
        .in<Height>("high", 0.02,
                    "Height of value 1, in length units of object space; if equal to `low`, an "
                    "edge of a pixel",
                    slider(-0.1, 0.1), unit("m"))
        .out<Float>("value", "0 to 1: the mean over the pixel")
        .body([](Float height, Float low, Float high) {
            const Float gap = named("gap", high - low);
            const Float range = named("range", select(abs(gap) > 1e-6, gap, 1e-6));
            const Float t = named("t", (height - low) / range);
            return saturate_mean(t, box_width(t));
        }),

    mask_family("edge_wear", "Edge wear",
                "Where a relief is above or below a smoother one: worn edges and dirty cavities.")
        .in<Height>("height", 0, "In length units of object space")
        .in<Height>("smooth", 0,
                    "The same relief with less detail, such as fewer octaves, in length units of "
                    "object space")
        .in<Height>(
            "level", 0.002,
            "How far above or below, in the middle of the edge, in length units of object space",
            slider(0, 0.02), unit("m"))
        .in<Height>("softness", 0.002,
                    "Width of the edge, in length units of object space; at least a pixel",
                    slider(0, 0.02), limits(0, 1e6), unit("m"))
        .out<Float>("edges", "1 where the relief is higher")
        .out<Float>("cavities", "1 where it is lower")
        .body([](Float height, Float smooth, Float level, Float softness) {
            const Float above = named("above", height - smooth);
            const Float width = named("edge_width", max(softness, box_width(above)));
            return std::tuple{smooth_edge(above, level, width), smooth_edge(-above, level, width)};
        }),

    mask_family("curvature", "Curvature",
                "Convex and concave parts of a relief: worn edges and dirty corners.")
        .field<Height>("height", surface::uv0,
                       "The relief as made from uv0, in length units of object space")
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .in<Float>("span", 0.01,
                   "How far around the relief is compared, in uv units; at least a pixel",
                   slider(0.001, 0.1), limits(1e-4, 1e6))
        .in<Height>("level", 0.002,
                    "How far above or below the mean around it a mask is 1, in length units of "
                    "object space",
                    slider(0.0005, 0.02), limits(3e-4, 1e6), unit("m"))
        .out<Float>("convex", "0 to 1: edges and tops")
        .out<Float>("concave", "0 to 1: corners and hollows")
        .out<Height>("above",
                     "Height over the mean of eight points around it: minus a quarter of the "
                     "Laplacian times the square of the span",
                     unit("m"))
        .body([](Field<Float> height, vec2 uv, Float span, Float level) {
            const Float far = named("far", max(span, footprint(uv)));
            const auto beside = [&](vec2 way) {
                return height(uv + way * far) + height(uv - way * far);
            };
            const double d = std::numbers::sqrt2 / 2;
            const Float around = named("around", 0.125 * (beside({1, 0}) + beside({0, 1}) +
                                                          beside({d, d}) + beside({d, -d})));
            const Float above = named("above", height(uv) - around);
            const Float t = named("t", above / level), width = box_width(t);
            return std::tuple{saturate_mean(t, width), saturate_mean(-t, width), above};
        }),

    seen_from(mask_family("fresnel", "Fresnel",
                          "The part of light that a smooth surface reflects to the eye: more at "
                          "grazing angles."))
        .choice("model", {"exact", "power"},
                "Unpolarized light on a dielectric, or base + (1 - base) (1 - cosine)^exponent")
        .in<Float>("ior", 1.5, "Index of refraction, for `exact`", slider(1, 3), limits(0.01, 1e6))
        .in<Float>("base", 0.04, "Reflected part seen from straight above, for `power`",
                   slider(0, 1))
        .in<Float>("exponent", 5, "How fast it rises, for `power`", slider(0.1, 10), limits(0, 1e6))
        .out<Float>("value", "0 to 1")
        .body(
            [](vec3 normal, vec3 view, FresnelModel model, Float ior, Float base, Float exponent) {
                const Float cosine = named("cosine", min(abs(dot(normal, view)), 1));
                if (model == FresnelModel::exact) return dielectric_fresnel(cosine, ior);
                return mix(base, 1, pow(1 - cosine, exponent));
            }),

    seen_from(mask_family("facing", "Facing",
                          "0 where the surface faces the eye, 1 at grazing angles: rims, cloth."))
        .in<Float>("blend", 0.5, "Below 0.5 a narrower rim, above a wider one; 0.5 is 1 - cosine",
                   slider(0, 0.99), limits(0, 0.99999))
        .out<Float>("value", "0 to 1")
        .body([](vec3 normal, vec3 view, Float blend) {
            return 1 - pow(min(abs(dot(normal, view)), 1), facing_exponent(blend));
        })};
constinit std::span<Node> mask_nodes = mask_list;

}  // namespace wrinkle::nodes
