// Maps projected along all three axes and blended by the normal. Slopes are summed into one
// gradient in space (Golubev, eqs. 45-49), not blended as normals.
#include "nodes/height_slope.h"
#include "nodes/ports.h"
#include "nodes/projection.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

#define TILING_DOC "Repeats per length unit"
#define SHARPNESS_DOC "How fast the nearest axis wins; 1 is the softest"
#define TRIPLANAR_BASE_DOC                                                                   \
    "The normal that chooses among the axes and that the bump is put on: the surface's, or " \
    "that of a resolve"

Node triplanar_weights_node =
    node("triplanar_weights", "Triplanar weights",
         "How much each axis counts at a normal, to blend three projections by hand.")
        .family("triplanar")
        .in<Normal>("normal", surface::normal, "Any length")
        .in<Float>("sharpness", 3, SHARPNESS_DOC, slider(1, 8), limits(1, 64))
        .in<Float>("threshold", 0.2, "Axes whose cosine is below this count nothing",
                   slider(0, 0.5), limits(0, 0.57))
        .out<vec3>("weights", "Of x, y and z; their sum is 1; constant under differentiation")
        .out<Float>("x", "The weight of the x axis")
        .out<Float>("y", "The weight of the y axis")
        .out<Float>("z", "The weight of the z axis")
        .body([](vec3 normal, Float sharpness, Float threshold) {
            const vec3 w = triplanar_weights(normal, sharpness, threshold);
            return std::tuple{w, w.x(), w.y(), w.z()};
        });

// Returns the weighted sum of `read` at the lookups of the three planes.
template <class Read>
static auto blend(const Planes& at, vec3 weights, Read read) {
    return read(at.x) * weights.x() + read(at.y) * weights.y() + read(at.z) * weights.z();
}

static Planes tiled(vec3 point, vec3 side, Float tiling) {
    return planes_at(point * tiling, side);
}

struct TriplanarColor {
    Image image;
    vec3 point, normal;
    Float tiling, sharpness;
};

Node triplanar_color_node =
    node("triplanar_color", "Triplanar colour", "The colour of a picture, without any uv.")
        .family("triplanar")
        .in<Image>("image", "The picture; sRGB unless it says otherwise", encoding("srgb"))
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<Normal>("normal", surface::normal, "Chooses among the axes")
        .in<Float>("tiling", 1, TILING_DOC, slider(0, 8), unit("x"))
        .in<Float>("sharpness", 3, SHARPNESS_DOC, slider(1, 8), limits(1, 64))
        .out<Color>("color", "Linear colour")
        .out<Float>("alpha", "Opacity, 0 to 1")
        .body([](TriplanarColor in) {
            const vec3 weights = triplanar_weights(in.normal, in.sharpness);
            const Planes at = tiled(in.point, side_of(front_of(in.normal)), in.tiling);
            const vec4 color = blend(at, weights, [&](vec2 uv) { return in.image.sample(uv); });
            return std::tuple{color.rgb(), color.a()};
        });

struct TriplanarHeightMap {
    Image image;
    vec3 point;
    Float tiling, amplitude, midlevel;
    HeightQuality quality;
    Float sharpness;
    vec3 base;
};

Node triplanar_height_map_node =
    node("triplanar_height_map", "Triplanar height map",
         "A relief from a picture of its heights, without any uv.")
        .family("triplanar")
        .in<Image>("image",
                   "Heights from 0 to 1 in the red channel; linear unless it says otherwise",
                   encoding("linear"))
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<Float>("tiling", 1, TILING_DOC, slider(0, 8), unit("x"))
        .in<Float>("amplitude", 0.02, "Height of white over black, in length units of object space",
                   slider(0, 0.2), unit("m"))
        .in<Float>("midlevel", 0.5, "The value in the picture that is height 0", slider(0, 1))
        .choice("quality", HEIGHT_QUALITIES, HEIGHT_QUALITY_DOC)
        .in<Float>("sharpness", 3, SHARPNESS_DOC, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, TRIPLANAR_BASE_DOC)
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .out<Gradient>("gradient", "Its bump")
        .body([](TriplanarHeightMap in) {
            const vec3 weights = triplanar_weights(in.base, in.sharpness);
            const Planes at = tiled(in.point, side_of(front_of(in.base)), in.tiling);
            const Float value =
                blend(at, weights, [&](vec2 uv) { return read_height(in.image, uv, in.quality); });
            const Float height = (value - in.midlevel) * in.amplitude;
            return std::tuple{height, gradient_from_height(height, Base(in.base))};
        });

struct TriplanarSlopes {
    Image image;
    vec3 point;
    Float tiling, strength;
    Scale scale;
    Float sharpness;
    vec3 base;
};

// read(uv, strength) returns the slopes of a map, per uv unit, times the strength.
template <class Read>
static auto triplanar_slopes(const TriplanarSlopes& in, Read read) {
    const vec3 weights = triplanar_weights(in.base, in.sharpness) * in.strength;
    const vec3 side = side_of(front_of(in.base));
    const Planes at = tiled(in.point, side, in.tiling);
    const Planes slopes{read(at.x, weights.x()), read(at.y, weights.y()), read(at.z, weights.z())};
    const Float per_length = in.scale == Scale::surface ? in.tiling : Float(1);
    const vec3 volume = volume_of(slopes, side) * per_length;
    return std::tuple{gradient_from_volume(volume, Base(in.base)), volume};
}

#define VOLUME_DOC "The gradient in object space, before its part along the normal is taken off"

Node triplanar_derivative_map_node =
    node("triplanar_derivative_map", "Triplanar derivative map",
         "A bump from a picture of slopes, without any uv.")
        .family("triplanar")
        .in<Image>("image", "Slopes; 0.5 is flat unless it says otherwise", encoding("derivative"))
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<Float>("tiling", 1, TILING_DOC, slider(0, 8), unit("x"))
        .in<Float>("strength", 1,
                   "Factor of the slopes; for the scale `surface` a length of object space",
                   slider(-2, 2), unit("x"))
        .choice("scale", SCALES, SCALE_DOC)
        .in<Float>("sharpness", 3, SHARPNESS_DOC, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, TRIPLANAR_BASE_DOC)
        .out<Gradient>("gradient", "The bump")
        .out<vec3>("volume", VOLUME_DOC)
        .body([](TriplanarSlopes in) {
            return triplanar_slopes(
                in, [&](vec2 uv, Float strength) { return in.image.sample(uv).xy() * strength; });
        });

Node triplanar_normal_map_node =
    node("triplanar_normal_map", "Triplanar normal map",
         "A bump from a tangent-space normal map, without any uv. Slopes are limited to 128.")
        .family("triplanar")
        .in<Image>("image", "Tangent-space normals; green is up unless it says otherwise",
                   encoding("normal_gl"))
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<Float>("tiling", 1, TILING_DOC, slider(0, 8), unit("x"))
        .in<Float>("strength", 1,
                   "Factor of the slopes: 1 leaves it unchanged, negative inverts it",
                   slider(-2, 2), unit("x"))
        .choice("scale", SCALES, SCALE_DOC, static_cast<int>(Scale::unit))
        .in<Float>("sharpness", 3, SHARPNESS_DOC, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, TRIPLANAR_BASE_DOC)
        .out<Gradient>("gradient", "The bump")
        .out<vec3>("volume", VOLUME_DOC)
        .body([](TriplanarSlopes in) {
            return triplanar_slopes(in, [&](vec2 uv, Float strength) {
                const vec3 m = in.image.sample(uv).xyz();
                return normal_derivative(m, strength, frame(uv, Scale::surface)).slope();
            });
        });

struct TriplanarHeight {
    Field<Float> height;
    vec3 point;
    Float tiling, sharpness;
    vec3 base;
};

Node triplanar_height_node =
    node("triplanar_height", "Triplanar height",
         "Any relief over uv0, read on three planes instead: what is wired in needs no uv then.")
        .family("triplanar")
        .field<Height>("height", surface::uv0,
                       "A height made of surface.uv0, in length units of object space")
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<Float>("tiling", 1, "uv units per length unit", slider(0, 8), unit("x"))
        .in<Float>("sharpness", 3, SHARPNESS_DOC, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, TRIPLANAR_BASE_DOC)
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .out<Gradient>("gradient", "Its bump")
        .body([](TriplanarHeight in) {
            const vec3 weights = triplanar_weights(in.base, in.sharpness);
            const Planes at = tiled(in.point, side_of(front_of(in.base)), in.tiling);
            const Float height = blend(at, weights, [&](vec2 uv) { return in.height(uv); });
            return std::tuple{height, gradient_from_height(height, Base(in.base))};
        });

struct TriplanarDerivative {
    Field<Derivative> derivative;
    vec3 point;
    Float tiling;
    Scale scale;
    Float sharpness;
    vec3 base;
};

Node triplanar_derivative_node =
    node("triplanar_derivative", "Triplanar slopes",
         "Any slopes over uv0, read on three planes instead: what is wired in needs no uv then.")
        .family("triplanar")
        .field<Derivative>("derivative", surface::uv0, "Slopes made of surface.uv0; without: flat")
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<Float>("tiling", 1, "uv units per length unit", slider(0, 8), unit("x"))
        .choice("scale", SCALES, SCALE_DOC)
        .in<Float>("sharpness", 3, SHARPNESS_DOC, slider(1, 8), limits(1, 64))
        .in<Normal>("base", surface::normal, TRIPLANAR_BASE_DOC)
        .out<Gradient>("gradient", "The bump")
        .out<vec3>("volume", VOLUME_DOC)
        .body([](TriplanarDerivative in) {
            const vec3 weights = triplanar_weights(in.base, in.sharpness);
            const vec3 side = side_of(front_of(in.base));
            const Planes at = tiled(in.point, side, in.tiling);
            const Planes slopes{in.derivative(at.x).slope() * weights.x(),
                                in.derivative(at.y).slope() * weights.y(),
                                in.derivative(at.z).slope() * weights.z()};
            const Float per_length = in.scale == Scale::surface ? in.tiling : Float(1);
            const vec3 volume = volume_of(slopes, side) * per_length;
            return std::tuple{gradient_from_volume(volume, Base(in.base)), volume};
        });

}  // namespace wrinkle::nodes
