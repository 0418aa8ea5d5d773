// Maps projected along all three axes and blended by the normal. Slopes are summed into one
// gradient in space (Golubev, eqs. 45-49), not blended as normals.
#include <span>

#include "nodes/height_slope.h"
#include "nodes/ports.h"
#include "nodes/projection.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto triplanar_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("triplanar");
}

constexpr char tiling_doc[] = "Repeats per length unit";
constexpr char sharpness_doc[] = "How fast the nearest axis wins; 1 is the softest";
constexpr char triplanar_base_doc[] =
    "The normal that chooses among the axes and that the bump is put on: the surface's, or "
    "that of a resolve";

// Returns the weighted sum of `read` at the lookups of the three planes.
template <class Read>
static auto blend(const Planes& at, vec3 weights, Read read) {
    return read(at.x) * weights.x() + read(at.y) * weights.y() + read(at.z) * weights.z();
}

static Planes tiled(vec3 point, vec3 side, Float tiling) {
    return planes_at(point * tiling, side);
}

struct TriplanarHeightMap {
    Image image;
    vec3 point;
    Float tiling, amplitude, midlevel;
    HeightQuality quality;
    Float sharpness;
    vec3 base;
};

struct TriplanarSlopes {
    Image image;
    vec3 point;
    Float tiling, strength;
    Scale scale;
    Float sharpness;
    vec3 base;
};

// read(uv, factor) returns the slopes of a map, per uv unit, times the factor.
template <class In, class Read>
static auto triplanar_slopes(const In& in, vec3 weights, Read read) {
    const vec3 side = side_of(front_of(in.base));
    const Planes at = tiled(in.point, side, in.tiling);
    const Planes slopes{read(at.x, weights.x()), read(at.y, weights.y()), read(at.z, weights.z())};
    const Float per_length = in.scale == Scale::surface ? in.tiling : Float(1);
    const vec3 volume = volume_of(slopes, side) * per_length;
    return std::tuple{gradient_from_volume(volume, Base(in.base)), volume};
}

constexpr char volume_doc[] =
    "The gradient in object space, before its part along the normal is taken off";

struct TriplanarDerivative {
    Field<Derivative> derivative;
    vec3 point;
    Float tiling;
    Scale scale;
    Float sharpness;
    vec3 base;
};

static constinit Node triplanar_list[] = {
    triplanar_family("triplanar_weights", "Triplanar weights",
                     "How much each axis counts at a normal, to blend three projections by hand.")
        .in<Normal>("normal", surface::normal, "Any length")
        .in<Float>("sharpness", 3, sharpness_doc, slider(1, 8), limits(1, 64))
        .in<Float>("threshold", 0.2, "Axes whose cosine is below this count nothing",
                   slider(0, 0.5), limits(0, 0.57))
        .out<vec3>("weights",
                   "Weights of x, y and z; their sum is 1; constant under differentiation")
        .out<Float>("x", "The weight of the x axis")
        .out<Float>("y", "The weight of the y axis")
        .out<Float>("z", "The weight of the z axis")
        .body([](vec3 normal, Float sharpness, Float threshold) {
            const vec3 w = triplanar_weights(normal, sharpness, threshold);
            return std::tuple{w, w.x(), w.y(), w.z()};
        }),

    triplanar_family("triplanar_color", "Triplanar color", "The color of an image, without any uv.")
        .in<Image>("image", "The image; sRGB unless it says otherwise", encoding("srgb"))
        .in<vec3>("point", surface::position, point_doc)
        .in<Normal>("normal", surface::normal, "Chooses among the axes")
        .in<Float>("tiling", 1, tiling_doc, slider(0, 8), unit("x"))
        .in<Float>("sharpness", 3, sharpness_doc, slider(1, 8), limits(1, 64))
        .out<Color>("color", "Linear color")
        .out<Float>("alpha", "Opacity, 0 to 1")
        .body([](Image image, vec3 point, vec3 normal, Float tiling, Float sharpness) {
            const vec3 weights = triplanar_weights(normal, sharpness);
            const Planes at = tiled(point, side_of(front_of(normal)), tiling);
            const vec4 color = blend(at, weights, [&](vec2 uv) { return image.sample(uv); });
            return std::tuple{color.rgb(), color.a()};
        }),

    triplanar_family("triplanar_height_map", "Triplanar height map",
                     "A relief from an image of its heights, without any uv.")
        .in<Image>("image", height_map_doc, encoding("linear"))
        .in<vec3>("point", surface::position, point_doc)
        .in<Float>("tiling", 1, tiling_doc, slider(0, 8), unit("x"))
        .in<Float>("amplitude", 0.02, "Height of white over black, in length units of object space",
                   slider(0, 0.2), unit("m"))
        .in<Float>("midlevel", 0.5, "The value in the image that is height 0", slider(0, 1))
        .choice("quality", height_qualities, height_quality_doc)
        .in<Float>("sharpness", 3, sharpness_doc, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, triplanar_base_doc)
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .out<Gradient>("gradient", "Its bump")
        .body([](TriplanarHeightMap in) {
            const vec3 weights = triplanar_weights(in.base, in.sharpness);
            const Planes at = tiled(in.point, side_of(front_of(in.base)), in.tiling);
            const Float value =
                blend(at, weights, [&](vec2 uv) { return read_height(in.image, uv, in.quality); });
            const Float height = (value - in.midlevel) * in.amplitude;
            return std::tuple{height, gradient_from_height(height, Base(in.base))};
        }),

    triplanar_family("triplanar_derivative_map", "Triplanar derivative map",
                     "A bump from an image of slopes, without any uv.")
        .in<Image>("image", "Slopes; 0.5 is flat unless it says otherwise", encoding("derivative"))
        .in<vec3>("point", surface::position, point_doc)
        .in<Float>("tiling", 1, tiling_doc, slider(0, 8), unit("x"))
        .in<Float>("strength", 1,
                   "Factor of the slopes; for the scale `surface` a length of object space",
                   slider(-2, 2), unit("x"))
        .choice("scale", scales, scale_doc)
        .in<Float>("sharpness", 3, sharpness_doc, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, triplanar_base_doc)
        .out<Gradient>("gradient", "The bump")
        .out<vec3>("volume", volume_doc)
        .body([](TriplanarSlopes in) {
            const vec3 weights = triplanar_weights(in.base, in.sharpness) * in.strength;
            return triplanar_slopes(in, weights, [&](vec2 uv, Float factor) {
                return in.image.sample(uv).xy() * factor;
            });
        }),

    triplanar_family(
        "triplanar_normal_map", "Triplanar normal map",
        "A bump from a tangent-space normal map, without any uv. Slopes are limited to 128.")
        .in<Image>("image", normal_map_doc, encoding("normal_gl"))
        .in<vec3>("point", surface::position, point_doc)
        .in<Float>("tiling", 1, tiling_doc, slider(0, 8), unit("x"))
        .in<Float>("strength", 1, strength_doc, slider(-2, 2), unit("x"))
        .choice("scale", scales, scale_doc, static_cast<int>(Scale::unit))
        .in<Float>("sharpness", 3, sharpness_doc, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, triplanar_base_doc)
        .out<Gradient>("gradient", "The bump")
        .out<vec3>("volume", volume_doc)
        .body([](TriplanarSlopes in) {
            const vec3 weights = triplanar_weights(in.base, in.sharpness) * in.strength;
            return triplanar_slopes(in, weights, [&](vec2 uv, Float factor) {
                const vec3 m = in.image.sample(uv).xyz();
                return normal_derivative(m, factor, frame(uv, Scale::surface)).slope();
            });
        }),

    triplanar_family(
        "triplanar_height", "Triplanar height",
        "Any relief over uv0, read on three planes instead: what is wired in needs no uv then.")
        .field<Height>("height", surface::uv0,
                       "A height made of surface.uv0, in length units of object space")
        .in<vec3>("point", surface::position, point_doc)
        .in<Float>("tiling", 1, "uv units per length unit", slider(0, 8), unit("x"))
        .in<Float>("sharpness", 3, sharpness_doc, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, triplanar_base_doc)
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .out<Gradient>("gradient", "Its bump")
        .body([](Field<Float> field, vec3 point, Float tiling, Float sharpness, vec3 base) {
            const vec3 weights = triplanar_weights(base, sharpness);
            const Planes at = tiled(point, side_of(front_of(base)), tiling);
            const Float height = blend(at, weights, [&](vec2 uv) { return field(uv); });
            return std::tuple{height, gradient_from_height(height, Base(base))};
        }),

    triplanar_family(
        "triplanar_derivative", "Triplanar slopes",
        "Any slopes over uv0, read on three planes instead: what is wired in needs no uv then.")
        .field<Derivative>("derivative", surface::uv0, "Slopes made of surface.uv0; without: flat")
        .in<vec3>("point", surface::position, point_doc)
        .in<Float>("tiling", 1, "uv units per length unit", slider(0, 8), unit("x"))
        .choice("scale", scales, scale_doc)
        .in<Float>("sharpness", 3, sharpness_doc, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, triplanar_base_doc)
        .out<Gradient>("gradient", "The bump")
        .out<vec3>("volume", volume_doc)
        .body([](TriplanarDerivative in) {
            const vec3 weights = triplanar_weights(in.base, in.sharpness);
            return triplanar_slopes(in, weights, [&](vec2 uv, Float factor) {
                return in.derivative(uv).slope() * factor;
            });
        })};
constinit std::span<Node> triplanar_nodes = triplanar_list;

}  // namespace wrinkle::nodes
