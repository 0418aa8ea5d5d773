// Round and regular shapes by signed distance, their combinations, masks and bevels.
#include <cmath>
#include <numbers>
#include <span>

#include "nodes/footprint.h"
#include "nodes/random.h"
#include "nodes/shape.h"
#include "nodes/smooth.h"

namespace wrinkle::nodes {
using namespace sdk;

// The angle from the y axis, clockwise.
static Float angle_from_up(vec2 p) {
    return named("angle", atan(p.x(), p.y()));
}

static Float box_distance(vec2 p, vec2 half, Float radius) {
    const auto distance =
        function("box_distance(p, extent, radius)", [](vec2 p, vec2 extent, Float radius) {
            const vec2 q = named("q", abs(p) - extent + radius);
            return length(max(q, 0)) + min(max(q.x(), q.y()), 0) - radius;
        });
    return distance(p, half, min(radius, min(half.x(), half.y())));
}

static Float polygon_distance(vec2 p, int sides, Float inradius) {
    const double half = std::numbers::pi / sides;
    const Float angle = angle_from_up(p);
    const Float side = named("side", angle - 2 * half * floor(angle / (2 * half) + 0.5));
    const Float reach = inradius * std::tan(half);
    const vec2 q = named("q", length(p) * vec2(cos(side), sin(side)));
    const vec2 way = named("way", q - vec2(inradius, clamp(q.y(), -reach, reach)));
    return length(way) * sign_nonzero(way.x());
}

static Float star_distance(vec2 p, int points, Float pointedness, Float radius) {
    const double half = std::numbers::pi / points;
    const Float side = named("side", mod(angle_from_up(p), 2 * half) - half);
    const vec2 q = named("q", length(p) * vec2(cos(side), abs(sin(side))) -
                                  radius * vec2(std::cos(half), std::sin(half)));
    const Float slant = named("slant", pi() / mix(2, points, pointedness));
    const vec2 edge = named("edge", vec2(cos(slant), sin(slant)));
    const Float along = clamp(-dot(q, edge), 0, radius * std::sin(half) / edge.y());
    const vec2 way = named("way", q + edge * along);
    return length(way) * sign_nonzero(way.x());
}

static Float arc_distance(vec2 p, Float half_angle, Float radius, Float width) {
    const vec2 q = named("q", vec2(abs(p.x()), p.y()));
    const vec2 end = named("end", vec2(sin(half_angle), cos(half_angle)));
    const Bool beyond = end.y() * q.x() > end.x() * q.y();
    return select(beyond, length(q - radius * end), abs(length(q) - radius)) - width;
}

static Float ellipse_distance(vec2 p, vec2 half) {
    const Float k0 = named("k0", length(p / half)), k1 = named("k1", length(p / (half * half)));
    return select(k1 > 0, k0 * divide(k0 - 1, k1), -min(half.x(), half.y()));
}

enum class Combination { union_, intersection, subtraction, exclusion };

static SmoothMinimum combined(Combination how, Float a, Float b, Float band, Seam seam) {
    if (how == Combination::union_) return smooth_minimum(a, b, band, seam);
    if (how == Combination::exclusion) {
        const auto [joined, share] = smooth_minimum(a, b, band, seam);
        return {max(joined, -max(a, b)), share};
    }
    const auto [d, share] =
        smooth_minimum(-a, how == Combination::subtraction ? b : -b, band, seam);
    return {-d, share};
}

enum class Profile { linear, smooth, round, cove };

// A profile from 0 to 1 over t, with a slope of at most 22: `round` and `cove` start a 256th from
// their vertical end.
static Float profile_of(Profile profile, Float t) {
    constexpr double start = 1.0 / 256,
                     first = 0.08830198871451027;  // first: the quarter circle at start
    const auto circle = [&](Float x) {
        const Float u = named("u", start + (1 - start) * x);
        return (sqrt(u * (2 - u)) - first) / (1 - first);
    };
    switch (profile) {
        case Profile::linear:
            return t;
        case Profile::smooth:
            return t * t * (3 - 2 * t);
        case Profile::round:
            return circle(t);
        default:
            return 1 - circle(1 - t);
    }
}

// A box-filtered edge: the covered part of the pixel, at least `softness` wide.
static Float coverage(Float distance, Float softness) {
    const Float width = max(max(softness, box_width(distance)), 1e-6);
    return saturate(0.5 - distance / width);
}

static constinit Node shape_list[] = {
    distance_out(shape("sd_circle", "Circle", "The distance to a circle.")
                     .in<Float>("radius", 0.3, "Radius, in uv units", slider(0, 0.5)))
        .body([](vec2 uv, vec2 center, Float rotation, Float radius) {
            return length(local(uv, center, rotation)) - radius;
        }),

    distance_out(shape("sd_ring", "Ring", "The distance to a ring.")
                     .in<Float>("radius", 0.3, "Radius of its middle, in uv units", slider(0, 0.5))
                     .in<Float>("width", 0.1, "Width of the ring, in uv units", slider(0, 0.5)))
        .body([](vec2 uv, vec2 center, Float rotation, Float radius, Float width) {
            return abs(length(local(uv, center, rotation)) - radius) - 0.5 * width;
        }),

    distance_out(shape("sd_box", "Box", "The distance to a box, with rounded corners or not.")
                     .in<vec2>("size", {0.6, 0.4}, "Width and height, in uv units", slider(0, 1),
                               limits(0, 1e6))
                     .in<Float>("radius", 0, "Radius of the corners, in uv units", slider(0, 0.5),
                                limits(0, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, vec2 size, Float radius) {
            return box_distance(local(uv, center, rotation), 0.5 * size, radius);
        }),

    distance_out(shape_family("sd_segment", "Segment", "The distance to a line with round ends.")
                     .in<vec2>("uv", surface::uv0, "Where to read it, on any uv set")
                     .in<vec2>("a", {0.2, 0.5}, "One end", slider(0, 1))
                     .in<vec2>("b", {0.8, 0.5}, "The other end", slider(0, 1))
                     .in<Float>("radius", 0.1, "Half of its width, in uv units", slider(0, 0.5)))
        .body([](vec2 uv, vec2 a, vec2 b, Float radius) {
            const vec2 from = named("from", uv - a), line = named("line", b - a);
            const Float along = saturate(divide(dot(from, line), dot(line, line)));
            return length(from - along * line) - radius;
        }),

    distance_out(shape("sd_polygon", "Polygon", "The distance to a regular polygon, a side up.")
                     .count("sides", 6, 3, 32, "How many sides it has")
                     .in<Float>("radius", 0.3, "From the middle to a side, in uv units",
                                slider(0, 0.5), limits(0, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, int sides, Float radius) {
            return polygon_distance(local(uv, center, rotation), sides, radius);
        }),

    distance_out(shape("sd_star", "Star", "The distance to a star, a point up.")
                     .count("points", 5, 3, 32, "How many points it has")
                     .in<Float>("pointedness", 0.33,
                                "1 is the thinnest star, 0 a polygon of twice as many sides",
                                slider(0, 1), limits(0, 1))
                     .in<Float>("radius", 0.4, "From the middle to a point, in uv units",
                                slider(0, 0.5), limits(0, 1e6)))
        .body(
            [](vec2 uv, vec2 center, Float rotation, int points, Float pointedness, Float radius) {
                return star_distance(local(uv, center, rotation), points, pointedness, radius);
            }),

    distance_out(shape("sd_arc", "Arc", "The distance to a part of a ring, with round ends.")
                     .in<Float>("angle", 90, "From end to end, the middle up", slider(0, 360),
                                limits(0, 360), unit("deg"))
                     .in<Float>("radius", 0.3, "Radius of its middle, in uv units", slider(0, 0.5),
                                limits(0, 1e6))
                     .in<Float>("width", 0.1, "Width of the arc, in uv units", slider(0, 0.5)))
        .body([](vec2 uv, vec2 center, Float rotation, Float angle, Float radius, Float width) {
            return arc_distance(local(uv, center, rotation), radians(0.5 * angle), radius,
                                0.5 * width);
        }),

    distance_out(
        shape("sd_ellipse", "Ellipse",
              "Nearly the distance to an ellipse: right at the edge, to first order around it.")
            .in<vec2>("size", {0.6, 0.4}, "Width and height, in uv units", slider(0.01, 1),
                      limits(1e-3, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, vec2 size) {
            return ellipse_distance(local(uv, center, rotation), 0.5 * size);
        }),

    shape_family("truchet", "Truchet tiles",
                 "The distance to curved lines: two quarter circles in each square of a grid, "
                 "turned at random.")
        .in<vec2>("uv", surface::uv0, "Where to read it, on any uv set")
        .in<Float>("scale", 8, "Squares per uv unit", slider(1, 32), limits(1e-6, 1e6), unit("x"))
        .in<Float>("width", 0.2, "Width of the lines, in squares", slider(0, 1))
        .count("seed", 0, 0, 65535, "Another seed turns other squares")
        .out<Float>("distance", "To the edge of the lines, negative inside, in uv units")
        .out<vec2>("cell", "The square: whole numbers")
        .out<vec3>("random", "Three random numbers of the square, 0 to below 1")
        .out<vec2>("center", "The middle of the square, on the uv set")
        .out<vec2>("local", "Position in the square, -0.5 to 0.5, with the slopes of the uv")
        .out<Float>("detail", "1 near, 0 where a pixel covers a square")
        .body([](vec2 uv, Float scale, Float width, int seed) {
            const vec2 p = named("p", uv * scale), cell = named("cell", floor(p));
            const Uint bits = random_bits(cell, 0, seed);
            const vec2 local = named("local", p - cell - 0.5);
            const vec2 way = named("way", local * vec2(1 - 2 * Float(bits & 1u), 1));
            const Float first = abs(length(way - 0.5) - 0.5), second = abs(length(way + 0.5) - 0.5);
            return std::tuple{(min(first, second) - 0.5 * width) / scale,
                              cell,
                              random3(bits),
                              (cell + 0.5) / scale,
                              local,
                              fade(footprint(p))};
        }),

    shape_family("shape_combine", "Combine shapes", "Joins or cuts two shapes, with soft seams.")
        .in<Float>("a", 0, "Distance to one shape", slider(-1, 1))
        .in<Float>("b", 0, "Distance to the other shape", slider(-1, 1))
        .choice("mode", {"union", "intersection", "subtraction", "exclusion"},
                "Inside of either, of both, of a but not b, or of one only")
        .in<Float>("smoothness", 0, "Distance below which the seam is rounded or cut, in uv units",
                   slider(0, 0.5), limits(0, 1e6))
        .choice("seam", {"quadratic", "cubic", "chamfer"},
                "Rounded by a parabola, smoother by a cubic, or cut straight at 45 degrees")
        .out<Float>("distance", "To the edge, negative inside; inside it is a bound")
        .out<Float>("share", "0 to 1: how much of the result is b, to mix two colors alike")
        .body([](Float a, Float b, Choice mode, Float smoothness, Choice seam) {
            const auto [distance, share] = combined(static_cast<Combination>(int(mode)), a, b,
                                                    smoothness, static_cast<Seam>(int(seam)));
            return std::tuple{distance, share};
        }),

    shape_family("shape_onion", "Onion", "Makes a shape larger, or a line along its edge.")
        .in<Float>("distance", 0, "Distance to the shape", slider(-1, 1))
        .in<Float>("grow", 0, "Moves the edge outward and rounds it, in uv units",
                   slider(-0.2, 0.2))
        .flag("line", false, "A line along the edge instead of the shape")
        .in<Float>("width", 0.02, "Width of the line, in uv units", slider(0, 0.2))
        .flag("invert", false, "The outside of the result instead of its inside")
        .out<Float>("distance", "Distance to the changed shape")
        .body([](Float distance, Float grow, bool line, Float width, bool invert) {
            const Float grown = distance - grow;
            const Float changed = line ? abs(grown) - 0.5 * width : grown;
            return invert ? -changed : changed;
        }),

    shape_family("shape_fill", "Fill", "A mask: 1 inside of a shape, 0 outside, and its outline.")
        .in<Float>("distance", 0, "Distance to the shape", slider(-1, 1))
        .in<Float>("softness", 0, "Width of the edge, at least a pixel", slider(0, 0.2),
                   limits(0, 1e6))
        .in<Float>("width", 0.02, "Width of the outline", slider(0, 0.2))
        .out<Float>("value", "1 inside")
        .out<Float>("outline", "1 along the edge")
        .body([](Float distance, Float softness, Float width) {
            return std::tuple{coverage(distance, softness),
                              coverage(abs(distance) - 0.5 * width, softness)};
        }),

    shape_family("bevel", "Bevel", "A relief that rises from the edge of a shape inward.")
        .in<Float>("distance", 0, "Distance to the shape", slider(-1, 1))
        .in<Float>("width", 0.1, "Where it is full, from the edge; at least a pixel",
                   slider(0, 0.5), limits(0, 1e6))
        .choice("profile", {"linear", "smooth", "round", "cove"},
                "Straight, without creases, convex or concave", 1)
        .in<Float>("amplitude", 0.05, "Height inside, in length units of object space",
                   slider(-0.2, 0.2), unit("m"))
        .out<Height>("height", "Value times amplitude, in length units of object space", unit("m"))
        .out<Float>("value", "0 outside, 1 inside")
        .body([](Float distance, Float width, Choice profile, Float amplitude) {
            const Float rise = named("rise", max(max(width, box_width(distance)), 1e-6));
            const Float value = named("value", profile_of(static_cast<Profile>(int(profile)),
                                                          saturate(-distance / rise)));
            return std::tuple{value * amplitude, value};
        })};
constinit std::span<Node> shape_nodes = shape_list;

}  // namespace wrinkle::nodes
