// Shapes with corners and arcs by signed distance, exact inside and outside.
#include <span>

#include "nodes/shape.h"

namespace wrinkle::nodes {
using namespace sdk;

// From a point relative to one end of a segment, to the nearest point of the segment.
static vec2 from_segment(vec2 p, vec2 segment) {
    return p - segment * saturate(divide(dot(p, segment), dot(segment, segment)));
}
// Twice the area between two vectors, positive if b is to the left of a.
static Float area(vec2 a, vec2 b) {
    return a.x() * b.y() - a.y() * b.x();
}

static Float triangle_distance(vec2 p, vec2 a, vec2 b, vec2 c) {
    const auto distance =
        function("triangle_distance(p, a, b, c)", [](vec2 p, vec2 a, vec2 b, vec2 c) {
            const vec2 ab = named("ab", b - a), bc = named("bc", c - b), ca = named("ca", a - c);
            const vec2 pa = named("pa", p - a), pb = named("pb", p - b), pc = named("pc", p - c);
            const Float turn = named("turn", sign_nonzero(area(ab, bc)));
            // Positive inside: the least of the areas at its sides.
            const vec3 areas =
                named("areas", turn * vec3(area(ab, pa), area(bc, pb), area(ca, pc)));
            const Float least = named("least", min(areas.x(), min(areas.y(), areas.z())));
            const Float edge = min(length(from_segment(pa, ab)),
                                   min(length(from_segment(pb, bc)), length(from_segment(pc, ca))));
            return sign_nonzero(-least) * edge;  // a triangle without area has no inside
        });
    return distance(p, a, b, c);
}

// The lower half widths are `bottom`, the upper ones `top`.
static Float trapezoid_distance(vec2 p, Float bottom, Float top, Float half_height) {
    const vec2 q = named("q", vec2(abs(p.x()), p.y()));
    const Float end = named("end", select(q.y() < 0, bottom, top));
    const vec2 base = named("base", vec2(max(q.x() - end, 0), abs(q.y()) - half_height));
    const vec2 corner(bottom, -half_height), leg(top - bottom, 2 * half_height);
    const vec2 side = named("side", from_segment(q - corner, leg));
    const Bool inside = named("inside", area(leg, q - corner) > 0 && base.y() < 0);
    return select(inside, -1, 1) * min(length(base), length(side));
}

static Float rhombus_distance(vec2 p, vec2 half) {
    const vec2 corner(half.x(), 0), side(-half.x(), half.y());
    const vec2 way = named("way", abs(p) - corner);
    return -sign_nonzero(area(side, way)) * length(from_segment(way, side));
}

static Float pie_distance(vec2 p, Float half_angle, Float radius) {
    const vec2 q = named("q", vec2(abs(p.x()), p.y()));
    const vec2 side = named("side", vec2(sin(half_angle), cos(half_angle)));
    const Float straight = length(q - side * clamp(dot(q, side), 0, radius));
    return max(length(q) - radius, straight * sign_nonzero(area(q, side)));
}

// A disc less another one around (offset, 0). Their circles cross at `tip`, or there.
static Float moon_distance(vec2 p, Float offset, Float radius, Float cut) {
    const vec2 q = named("q", vec2(p.x(), abs(p.y())));
    const Float x = named("x", divide(radius * radius - cut * cut + offset * offset, 2 * offset));
    const Float square = named("square", radius * radius - x * x);
    const vec2 tip = named("tip", vec2(x, sqrt(max(square, 0))));
    const Bool at_tip =
        square > 0 && offset * area(q, tip) > offset * offset * max(tip.y() - q.y(), 0);
    const Float discs = max(length(q) - radius, cut - length(q - vec2(offset, 0)));
    return select(at_tip, length(q - tip), discs);
}

// The common part of two discs; its tips are up and down, or left and right if it is wider.
static Float vesica_distance(vec2 p, vec2 half) {
    const Bool upright = named("upright", half.y() > half.x());
    const vec2 q = named("q", abs(select(upright, p, p.yx())));
    const Float tip = named("tip", max(half.x(), half.y()));
    const Float wide = named("wide", min(half.x(), half.y()));
    const Float offset = named("offset", divide(tip * tip - wide * wide, 2 * wide));
    const Bool beyond = (q.y() - tip) * offset > q.x() * tip;
    // The length less the radius, as a quotient: both are large if the lens is thin.
    const Float over = dot(q, q) - tip * tip + 2 * offset * q.x();
    const Float sum = length(q + vec2(offset, 0)) + offset + wide;
    return select(beyond, length(q - vec2(0, tip)), over / sum);
}

// The tip is at 0, two half circles are on a square above it; the height is 1.1036.
static Float heart_distance(vec2 p) {
    const vec2 q = named("q", vec2(abs(p.x()), p.y()));
    const Float lobe = length(q - vec2(0.25, 0.75)) - 0.35355339059327376;
    const Float sum = named("sum", max(q.x() + q.y(), 0));
    const Float below =
        min(length(q - vec2(0, 1)), length(q - 0.5 * sum)) * sign_nonzero(q.x() - q.y());
    return select(q.x() + q.y() > 1, lobe, below);
}

static Float cross_distance(vec2 p, Float half_length, Float half_width) {
    const vec2 up = abs(p);
    const vec2 q = named("q", vec2(max(up.x(), up.y()), min(up.x(), up.y())));
    const vec2 end = named("end", q - vec2(half_length, half_width));
    const Float inside = min(length(max(half_width - q, 0)), -end.x());
    return select(max(end.x(), end.y()) > 0, length(max(end, 0)), -inside);
}

static constinit Node figure_list[] = {
    distance_out(shape_family("sd_triangle", "Triangle", "The distance to a triangle.")
                     .in<vec2>("uv", surface::uv0, "Where to read it, on any uv set")
                     .in<vec2>("a", {0.2, 0.25}, "One corner", slider(0, 1))
                     .in<vec2>("b", {0.8, 0.25}, "Another corner", slider(0, 1))
                     .in<vec2>("c", {0.5, 0.8}, "The third corner", slider(0, 1)))
        .body([](vec2 uv, vec2 a, vec2 b, vec2 c) { return triangle_distance(uv, a, b, c); }),

    distance_out(shape("sd_rhombus", "Rhombus", "The distance to a rhombus, a corner up.")
                     .in<vec2>("size", {0.5, 0.7}, "Width and height, in uv units", slider(0.01, 1),
                               limits(1e-3, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, vec2 size) {
            return rhombus_distance(local(uv, center, rotation), 0.5 * size);
        }),

    distance_out(shape("sd_trapezoid", "Trapezoid", "The distance to a symmetric trapezoid.")
                     .in<Float>("bottom", 0.7, "Width of the lower side, in uv units", slider(0, 1),
                                limits(0, 1e6))
                     .in<Float>("top", 0.4, "Width of the upper side, in uv units", slider(0, 1),
                                limits(0, 1e6))
                     .in<Float>("height", 0.5, "Between them, in uv units", slider(0.01, 1),
                                limits(1e-3, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, Float bottom, Float top, Float height) {
            return trapezoid_distance(local(uv, center, rotation), 0.5 * bottom, 0.5 * top,
                                      0.5 * height);
        }),

    distance_out(
        shape("sd_pie", "Pie", "The distance to a sector of a disc, upward.")
            .in<Float>("angle", 90, "Angle of the sector, from side to side", slider(0, 360),
                       limits(0, 360), unit("deg"))
            .in<Float>("radius", 0.4, "Radius, in uv units", slider(0, 0.5), limits(0, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, Float angle, Float radius) {
            return pie_distance(local(uv, center, rotation), radians(0.5 * angle), radius);
        }),

    distance_out(shape("sd_moon", "Moon", "The distance to a disc that another disc is cut out of.")
                     .in<Float>("radius", 0.4, "Radius of the disc, in uv units", slider(0, 0.5),
                                limits(0, 1e6))
                     .in<Float>("cut", 0.35, "Radius of the disc cut out, in uv units",
                                slider(0, 0.5), limits(0, 1e6))
                     .in<Float>("offset", 0.2,
                                "From the middle of the disc to that of the other, along u",
                                slider(-0.5, 0.5)))
        .body([](vec2 uv, vec2 center, Float rotation, Float radius, Float cut, Float offset) {
            return moon_distance(local(uv, center, rotation), offset, radius, cut);
        }),

    distance_out(
        shape("sd_vesica", "Vesica", "The distance to a lens: the common part of two equal discs.")
            .in<vec2>("size", {0.4, 0.8}, "Width and height, in uv units", slider(0.01, 1),
                      limits(1e-3, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, vec2 size) {
            return vesica_distance(local(uv, center, rotation), 0.5 * size);
        }),

    distance_out(shape("sd_heart", "Heart", "The distance to a heart, the tip down.")
                     .in<Float>("size", 0.8, "Height, in uv units; the width is 1.09 of it",
                                slider(0.01, 1), limits(1e-3, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, Float size) {
            constexpr double height = 1.1035533905932737;
            const Float scale = named("scale", size / height);
            const vec2 p = local(uv, center, rotation) / scale + vec2(0, 0.5 * height);
            return heart_distance(p) * scale;
        }),

    distance_out(
        shape("sd_cross", "Cross", "The distance to two bars that cross at right angles.")
            .in<Float>("length", 0.7, "Length of a bar, in uv units", slider(0, 1), limits(0, 1e6))
            .in<Float>("width", 0.2, "Width of a bar, up to its length", slider(0, 1),
                       limits(0, 1e6)))
        .body([](vec2 uv, vec2 center, Float rotation, Float length, Float width) {
            return cross_distance(local(uv, center, rotation), 0.5 * length,
                                  0.5 * min(width, length));
        })};
constinit std::span<Node> figure_nodes = figure_list;

}  // namespace wrinkle::nodes
