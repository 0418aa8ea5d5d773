// Texture coordinates bent, repeated and warped. A map or a pattern read there has the bump of the
// bent image by the chain rule.
#include <numbers>
#include <span>

#include "nodes/footprint.h"
#include "nodes/random.h"
#include "nodes/rotated.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto uv_tool(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("uv").in<vec2>("uv", surface::uv0, "The uv to change");
}
static constexpr auto about_center(const char* id, const char* title, const char* doc) {
    return uv_tool(id, title, doc).in<vec2>("center", 0.5, "The fixed point", slider(0, 1));
}

struct Tile {
    vec2 uv;
    bool flip, turn;
    int seed;
};

// The position in a cell, from -0.5 to 0.5, mirrored and turned by quarters at random.
static vec2 turned_tile(vec2 way, Uint bits, bool flip, bool turn) {
    if (flip) way = way * vec2(1 - 2 * Float(bits & 1u), 1);
    if (!turn) return way;
    const vec2 quarter = select((bits & 2u) != 0u, vec2(-way.y(), way.x()), way);
    return named("turned", select((bits & 4u) != 0u, -quarter, quarter));
}

static constinit Node uv_tools_list[] = {
    about_center("uv_rotate", "Rotate UV", "A uv turned about a point.")
        .in<Float>("angle", 0, "The uv turns anticlockwise, textures clockwise", slider(-180, 180),
                   unit("deg"))
        .out<vec2>("uv", "The turned uv")
        .body([](vec2 uv, vec2 center, Float angle) {
            return rotated(uv - center, radians(angle)) + center;
        }),

    about_center("uv_mirror", "Mirror UV", "One side of a line instead of both.")
        .flag("mirror_u", true, "Mirrors the left side by u")
        .flag("mirror_v", false, "Mirrors the lower side by v")
        .out<vec2>("uv", "The mirrored uv; its crease is on the line")
        .body([](vec2 uv, vec2 center, bool mirror_u, bool mirror_v) {
            const vec2 way = named("way", uv - center);
            return vec2(mirror_u ? abs(way.x()) : way.x(), mirror_v ? abs(way.y()) : way.y()) +
                   center;
        }),

    about_center("uv_shear", "Shear UV", "Slants a uv.")
        .in<vec2>("amount", 0, "How far u grows with v, and v with u", slider(-1, 1))
        .out<vec2>("uv", "The slanted uv")
        .body([](vec2 uv, vec2 center, vec2 amount) { return uv + (uv - center).yx() * amount; }),

    uv_tool("uv_tile", "Tile UV", "Repeats the unit square, mirrored or turned at random.")
        .flag("flip", false, "Mirrors half of the cells by u")
        .flag("turn", false, "Turns cells by quarters")
        .count("seed", 0, 0, 65535, "Another seed turns other cells")
        .out<vec2>("uv", "0 to 1 in each cell")
        .out<vec2>("cell", "The cell: whole numbers")
        .body([](Tile in) {
            const vec2 cell = named("cell", floor(in.uv));
            const vec2 way = named("way", in.uv - cell - 0.5);
            const Uint bits = named("bits", random_bits(cell, 0, in.seed));
            return std::tuple{turned_tile(way, bits, in.flip, in.turn) + 0.5, cell};
        }),

    about_center("uv_swirl", "Swirl UV", "Turns a uv within a circle, most in its middle.")
        .in<Float>("angle", 90, "Turn in the middle", slider(-720, 720), unit("deg"))
        .in<Float>("radius", 0.5, "Radius of the circle, in uv units", slider(0.01, 1),
                   limits(1e-6, 1e6))
        .out<vec2>("uv", "The turned uv")
        .body([](vec2 uv, vec2 center, Float angle, Float radius) {
            const vec2 way = named("way", uv - center);
            const Float inside = named("inside", max(1 - length(way) / radius, 0));
            return rotated(way, radians(angle) * inside * inside) + center;
        }),

    about_center("uv_spherize", "Spherize UV", "Bulges a uv within a circle, as a lens does.")
        .in<Float>("amount", 0.5, "Above 0 magnifies the middle, by 1 / (1 - amount)",
                   slider(-1, 0.9), limits(-1, 0.99))
        .in<Float>("radius", 0.5, "Radius of the circle, in uv units", slider(0.01, 1),
                   limits(1e-6, 1e6))
        .out<vec2>("uv", "The bulged uv")
        .body([](vec2 uv, vec2 center, Float amount, Float radius) {
            const vec2 way = named("way", uv - center);
            const Float inside = named("inside", max(1 - dot(way, way) / (radius * radius), 0));
            return way * (1 - amount * inside * inside) + center;
        }),

    about_center("uv_polar", "Polar UV", "The distance and the angle from a point.")
        .in<Float>("scale", 1, "Factor of the distance", slider(0, 8), unit("x"))
        .in<Float>("repeat", 1, "Factor of the angle; whole numbers close a pattern", slider(1, 16),
                   unit("x"))
        .out<vec2>("uv",
                   "u: the distance; v: turns anticlockwise from u, -0.5 to 0.5 with a seam behind")
        .body([](vec2 uv, vec2 center, Float scale, Float repeat) {
            const vec2 way = named("way", uv - center);
            return vec2(length(way) * scale, atan(way.y(), way.x()) * (repeat / two_pi()));
        }),

    about_center("uv_kaleidoscope", "Kaleidoscope", "One sector, mirrored all around a point.")
        .count("segments", 5, 2, 32, "How many mirrored pairs go around")
        .in<Float>("angle", 0, "Turns the sector", slider(-180, 180), unit("deg"))
        .out<vec2>("uv", "In the sector, mirrored")
        .body([](vec2 uv, vec2 center, int segments, Float angle) {
            const vec2 way = named("way", uv - center);
            const double sector = 2 * std::numbers::pi / segments;
            const Float from = named("from", atan(way.y(), way.x()) - radians(angle));
            const Float folded = named("folded", abs(mod(from + sector / 2, sector) - sector / 2));
            const Float to = named("to", folded + radians(angle));
            return length(way) * vec2(cos(to), sin(to)) + center;
        }),

    uv_tool("uv_warp", "Warp UV", "Moves a uv by a vector.")
        .in<vec2>("vector", 0.5, "The direction, 0.5 for none: a color or two noises", slider(0, 1))
        .in<Float>("amount", 0.1,
                   "Factor, in uv units; times the greatest slope below 1, or it folds",
                   slider(0, 1))
        .out<vec2>("uv", "The moved uv")
        .body(
            [](vec2 uv, vec2 vector, Float amount) { return uv + (vector - 0.5) * (2 * amount); }),

    uv_tool("uv_warp_directional", "Warp UV along a direction", "Moves a uv by a number.")
        .in<Float>("value", 0, "How far, such as a noise", slider(-1, 1))
        .in<Float>("middle", 0, "The value that does not move it", slider(0, 1))
        .in<Float>("angle", 0, "Where it moves, anticlockwise from u", slider(-180, 180),
                   unit("deg"))
        .in<Float>("amount", 0.1,
                   "Factor, in uv units; times the greatest slope below 1, or it folds",
                   slider(0, 1))
        .out<vec2>("uv", "The moved uv")
        .body([](vec2 uv, Float value, Float middle, Float angle, Float amount) {
            const Float turn = named("turn", radians(angle));
            return uv + (value - middle) * amount * vec2(cos(turn), sin(turn));
        }),

    uv_tool("uv_warp_slope", "Warp UV by slopes",
            "Moves a uv up the slopes of a number, or down: a pattern swells around its hills or "
            "gathers on them.")
        .field<Float>("value", surface::uv0, "A number as made from uv0, such as a noise")
        .in<Float>("span", 0.01,
                   "How far to each side the slope is measured, in uv units; at least a pixel",
                   slider(0.001, 0.1), limits(1e-4, 1e6))
        .in<Float>("amount", 0.01,
                   "How far a slope of 1 per uv unit moves it, in uv units; below 0 downhill",
                   slider(-0.1, 0.1))
        .out<vec2>("uv", "The moved uv")
        .out<vec2>("slope", "Change of the number per uv unit")
        .body([](vec2 uv, Field<Float> value, Float span, Float amount) {
            const Float far = named("far", max(span, footprint(uv)));
            const auto along = [&](vec2 way) {
                return (value(uv + way * far) - value(uv - way * far)) / (2 * far);
            };
            const vec2 slope = named("slope", vec2(along({1, 0}), along({0, 1})));
            return std::tuple{uv + slope * amount, slope};
        })};
constinit std::span<Node> uv_tools_nodes = uv_tools_list;

}  // namespace wrinkle::nodes
