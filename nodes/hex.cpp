// Textures without visible repeats: each hexagon of a grid reads a randomly rotated and moved copy
// of the texture, and three copies are blended at every point (M. Mikkelsen, "Practical Real-Time
// Hex-Tiling", 2022). Slopes are rotated with the texture, then blended; weights are constant under
// differentiation.
#include <span>

#include "nodes/constants.h"
#include "nodes/height_slope.h"
#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

// One of the three hexagons at a point: the uv and the rotation of its copy.
struct Tap {
    vec2 uv, right, up;  // uv in the copy; its derivatives along u and along v
    // Converts a slope in the copy to dh/d(u,v) of the surface.
    vec2 turned_back(vec2 slope) const { return {dot(slope, right), dot(slope, up)}; }
    // Returns the differentials of the copy's uv, from those of `at`: the copy's uv itself jumps at
    // the border to another hexagon.
    Changes changes(vec2 at) const {
        const auto turned = [this](const char* name, vec2 v) {
            return named(name, right * v.x() + up * v.y());
        };
        return {turned("copy_dx", ddx(at)), turned("copy_dy", ddy(at))};
    }
    vec4 read(Image image, vec2 at) const {
        const auto [x, y] = changes(at);
        return image.sample_grad(uv, x, y);
    }
};

struct HexBlend {
    vec3 weights;  // barycentric in the triangle of three centres; sum 1
    Tap taps[3];
};

// Grid of triangles between the centres of hexagons, sheared into squares. The function returns the
// barycentric weights and the three corners of the triangle around a point.
static auto grid_function() {
    return function("hex_grid(at)", [](vec2 at) {
        const Float tan_30 = named("tan_30 // 1 / sqrt(3)", Float(0.57735026918962576));
        const Float sec_30 = named("sec_30 // 2 / sqrt(3)", Float(1.1547005383792515));
        const vec2 sheared = named("sheared", vec2(at.x() - at.y() * tan_30, at.y() * sec_30));
        const vec2 cell = named("cell", floor(sheared)), f = named("f", sheared - cell);
        const Float rest = named("rest", 1 - f.x() - f.y());
        const Bool far = named("far", rest <= 0);
        const vec3 weights =
            select(far, vec3(-rest, 1 - f.y(), 1 - f.x()), vec3(rest, f.y(), f.x()));
        const Float corner = named("corner", Float(far));
        return std::tuple{weights, cell + vec2(corner), cell + vec2(corner, 1 - corner),
                          cell + vec2(1 - corner, corner)};
    });
}

// The function returns, for the hexagon of a corner, the uv in its copy, and cosine and sine of the
// copy's rotation; `size` is the number of grid cells per uv unit.
static auto copy_function() {
    return function("hex_copy(uv, corner, size, rotation)", [](vec2 uv, vec2 corner, Float size,
                                                               Float rotation) {
        const Uint bits = named("bits", hash(Int(corner.x()), Int(corner.y())));
        const Uint more = named("more", hash(bits));
        const Float angle = named("angle", (unit_float(bits) - 0.5) * (two_pi() * rotation));
        const vec2 right = named("right", vec2(cos(angle), sin(angle)));
        const vec2 up = named("up", vec2(-right.y(), right.x()));
        const vec2 centre =
            named("centre", vec2(corner.x() + 0.5 * corner.y(), corner.y() * sin_60()) / size);
        const vec2 way = named("way", uv - centre);
        const Float two_16 = named("two_16 // each half of the bits to [0, 1)", Float(65536));
        const vec2 moved = named("moved", vec2(Float(more >> 16u), Float(more & 0xffffu)) / two_16);
        return vec4(right * way.x() + up * way.y() + moved, right);
    });
}

static HexBlend hexagons_at(vec2 uv, Float hexagons, Float rotation) {
    const Float size =
        named("hex_size // 2 sqrt(3) times the hexagons", hexagons * 3.4641016151377544);
    const auto copy = copy_function();
    const auto tap = [&](vec2 corner) {
        const vec4 at = named("copy", copy(uv, corner, size, rotation));
        return Tap{at.xy(), at.zw(), vec2(-at.w(), at.z())};
    };
    const auto [weights, first, second, third] = grid_function()(uv * size);
    return {weights, {tap(first), tap(second), tap(third)}};
}

static Float min_weight() {
    return named("min_weight // of a corner, for a sum above zero", Float(1e-4));
}

// Returns twice Perlin's gain of weights of sum 1.
static vec3 contrasted(vec3 weights, Float contrast) {
    const Float k = log(1 - contrast) / -0.6931471805599453;
    return by_components(weights, [&](Float weight) {
        const Float twice = named("twice", 2 * weight);
        const Bool low = named("low", twice < 1);
        const Float part = named("part", pow(max(min(twice, 2 - twice), min_weight()), k));
        return select(low, part, 2 - part);
    });
}

// `strength`: visibility of each sample, 0 to 1; one of strength 1 weighs 2.5 times one of 0.
static vec3 blend_weights(const HexBlend& at, vec3 strength, Float exponent, Float contrast) {
    const vec3 shown = vec3(2.0 / 3) + strength;
    const vec3 weights = shown * pow(max(at.weights, vec3(min_weight())), exponent);
    return detach(contrasted(weights / dot(weights, vec3(1)), contrast));
}

template <class T>
static T blend(vec3 weights, T a, T b, T c) {
    return (a * weights.x() + b * weights.y() + c * weights.z()) / dot(weights, vec3(1));
}

// Adds the ports of the tiling.
template <class Declaration>
static constexpr auto hexagonal(const Declaration& declaration) {
    return declaration
        .template in<Float>("hexagons", 1, "Hexagons per repeat of the image, along one side",
                            slider(0.25, 4), limits(0.01, 100), unit("x"))
        .template in<Float>("rotation", 1,
                            "How much each hexagon is turned: 0 not at all, 1 by any angle",
                            slider(0, 1), limits(0, 1))
        .template in<Float>("exponent", 7, "How fast the nearest hexagon wins", slider(1, 8),
                            limits(1, 8))
        .template in<Float>("contrast", 0.5,
                            "0.5 leaves the blend as it is, more makes its borders harder",
                            slider(0.3, 0.8), limits(0.1, 0.9));
}

struct HexTileHeightMap {
    Image image;
    vec2 uv;
    Float amplitude, midlevel, hexagons, rotation, exponent, contrast;
    HeightQuality quality;
    Scale scale;
    vec3 base;
};

struct HexTileNormalMap {
    Image image;
    vec2 uv;
    Float strength, hexagons, rotation, exponent, contrast;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

static constinit Node hex_list[] = {
    hexagonal(
        node("hex_tile_color", "Hex-tiled color", "The color of an image, without visible repeats.")
            .family("hex")
            .in<Image>("image", "The image; sRGB unless it says otherwise", encoding("srgb"))
            .in<vec2>("uv", surface::uv0, "Where to read it"))
        .out<Color>("color", "Linear color")
        .body([](Image image, vec2 uv, Float hexagons, Float rotation, Float exponent,
                 Float contrast) {
            const HexBlend at = hexagons_at(uv, hexagons, rotation);
            const vec3 a = at.taps[0].read(image, uv).rgb();
            const vec3 b = at.taps[1].read(image, uv).rgb();
            const vec3 c = at.taps[2].read(image, uv).rgb();
            const vec3 luminance = named("luminance // of Rec. 709", vec3(0.2126, 0.7152, 0.0722));
            const vec3 bright(dot(a, luminance), dot(b, luminance), dot(c, luminance));
            return blend(blend_weights(at, saturate(bright), exponent, contrast), a, b, c);
        }),

    hexagonal(
        node("hex_tile_height_map", "Hex-tiled height map",
             "A relief from an image of its heights, without visible repeats.")
            .family("hex")
            .in<Image>("image", height_map_doc, encoding("linear"))
            .in<vec2>("uv", surface::uv0, "Where to read it")
            .in<Float>("amplitude", 0.02, amplitude_doc, slider(0, 0.2), unit("m"))
            .in<Float>("midlevel", 0.5, "The value in the image that is height 0", slider(0, 1)))
        .choice("quality", height_qualities, height_quality_doc)
        .choice("scale", scales, scale_doc)
        .in<Normal>("base", surface::normal, base_doc)
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .out<Gradient>("gradient", "Its bump, by the chosen scale")
        .out<Derivative>("derivative", "Its slopes with their frame")
        .body([](HexTileHeightMap in) {
            const HexBlend at = hexagons_at(in.uv, in.hexagons, in.rotation);
            const vec3 weights = blend_weights(at, vec3(1), in.exponent, in.contrast);
            const auto slope = [&](int i) {
                const Tap& tap = at.taps[i];
                return tap.turned_back(
                    height_slope(in.image, tap.uv, in.quality, tap.changes(in.uv)));
            };
            const auto read = [&](int i) { return at.taps[i].read(in.image, in.uv).x(); };
            const vec2 slopes = blend(weights, slope(0), slope(1), slope(2)) * in.amplitude;
            const Float value = blend(weights, read(0), read(1), read(2));
            const Float height = with_slope((value - in.midlevel) * in.amplitude, in.uv, slopes);
            const Derivative d(slopes, frame(in.uv, in.scale));
            return std::tuple{height, Gradient(d, Base(in.base)), d};
        }),

    bump_in_frame(hexagonal(node("hex_tile_normal_map", "Hex-tiled normal map",
                                 "A bump from a tangent-space normal map, without visible repeats. "
                                 "The map's mean must "
                                 "be "
                                 "flat, as that of any relief that tiles is.")
                                .family("hex")
                                .in<Image>("image", normal_map_doc, encoding("normal_gl"))
                                .in<vec2>("uv", surface::uv0, "Where to read it")
                                .in<Float>("strength", 1, strength_doc, slider(-2, 2), unit("x"))),
                  Scale::unit)
        .body([](HexTileNormalMap in) {
            const HexBlend at = hexagons_at(in.uv, in.hexagons, in.rotation);
            const Frame basis = frame(in.uv, in.frame, in.scale, in.direction);
            const auto slope = [&](int i) {
                const vec3 m = at.taps[i].read(in.image, in.uv).xyz();
                return at.taps[i].turned_back(normal_derivative(m, in.strength, basis).slope());
            };
            const vec2 a = slope(0), b = slope(1), c = slope(2);
            const vec3 square(dot(a, a), dot(b, b), dot(c, c));
            const vec3 tilt = sqrt(square / (vec3(1) + square));  // sine of the tilt
            const vec3 weights = blend_weights(at, tilt, in.exponent, in.contrast);
            return bump_of(Derivative(blend(weights, a, b, c), basis), in.base);
        })};
constinit std::span<Node> hex_nodes = hex_list;

}  // namespace wrinkle::nodes
