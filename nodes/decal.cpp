// Decals: images projected onto any surface inside a box, cone, sphere or capsule, and the two ways
// to combine their bump with the existing one. A projector faces along its direction; its image is
// not mirrored as seen from the projector.
#include <span>

#include "nodes/projection.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto decal_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("decal");
}

constexpr char decal_normal_doc[] = "Normal of the receiving surface; back faces receive nothing";
constexpr char edge_doc[] = "The part of its reach over which it fades out; 0 is a hard edge";
constexpr char angle_fade_doc[] = "Exponent of the cosine to the surface: 0 reaches every side";
constexpr char attenuation_doc[] = "0 to 1: how much of the decal arrives";

// Returns 1 inside, fading to 0 at the border, where `reached` is 1; `edge` is the width of the
// fade.
static Float inside(Float reached, Float edge) {
    return 1 - smoothstep(1 - edge, Float(1), reached);
}
// `towards`: unit direction from the surface to the projector.
static Float angle_fade(vec3 normal, vec3 towards, Float exponent) {
    return detach(pow(saturate(dot(normalize(normal), towards)), exponent));
}

struct DecalBox {
    vec3 point, normal, origin, direction, up, size;
    Float edge, angle_fade;
};

struct DecalCone {
    vec3 point, normal, origin, direction, up;
    Float angle, range, edge, angle_fade;
};

struct DecalSphere {
    vec3 point, normal, origin, axis, front;
    Float radius, edge, angle_fade;
};

struct DecalCapsule {
    vec3 point, normal, start, end, front;
    Float radius, edge, angle_fade;
};

static constinit Node decal_list[] = {
    decal_family("decal_box", "Box decal", "Projects an image through a box.")
        .in<vec3>("point", surface::position, point_doc)
        .in<Normal>("normal", surface::normal, decal_normal_doc)
        .in<vec3>("origin", {0, 0, 1}, "The centre of the box", slider(-2, 2))
        .in<vec3>("direction", {0, 0, -1}, "Where it projects to; any length", slider(-1, 1))
        .in<vec3>("up", {0, 1, 0}, "Where v grows; any length", slider(-1, 1))
        .in<vec3>("size", 1, "Width, height and depth in length units", slider(0.01, 4),
                  limits(1e-6, 1e6))
        .in<Float>("edge", 0.1, edge_doc, slider(0, 1), limits(0, 1))
        .in<Float>("angle_fade", 0.2, angle_fade_doc, slider(0, 4), limits(0, 64))
        .out<vec2>("uv", "0 to 1 across the box")
        .out<Float>("attenuation", attenuation_doc)
        .body([](DecalBox in) {
            const Axes axes = axes_of(-in.direction, in.up);
            const vec3 way = named("way", in.point - in.origin);
            const vec3 place = named("place", named("turned", into(axes, way)) / in.size);
            const vec3 reached = named("reached", abs(place) * 2);
            const Float within = inside(reached.x(), in.edge) * inside(reached.y(), in.edge) *
                                 inside(reached.z(), in.edge);
            return std::tuple{place.xy() + vec2(0.5),
                              within * angle_fade(in.normal, axes.z, in.angle_fade)};
        }),

    decal_family("decal_cone", "Cone decal",
                 "Projects an image from a point, like a slide projector.")
        .in<vec3>("point", surface::position, point_doc)
        .in<Normal>("normal", surface::normal, decal_normal_doc)
        .in<vec3>("origin", {0, 0, 2}, "Position of the projector", slider(-4, 4))
        .in<vec3>("direction", {0, 0, -1}, "Where it projects to; any length", slider(-1, 1))
        .in<vec3>("up", {0, 1, 0}, "Where v grows; any length", slider(-1, 1))
        .in<Float>("angle", 40, "From side to side of the cone", slider(1, 160), limits(0.1, 179),
                   unit("deg"))
        .in<Float>("range", 2, "How far it reaches, in length units", slider(0.01, 8),
                   limits(1e-6, 1e6))
        .in<Float>("edge", 0.1, edge_doc, slider(0, 1), limits(0, 1))
        .in<Float>("angle_fade", 0.2, angle_fade_doc, slider(0, 4), limits(0, 64))
        .out<vec2>("uv", "0 to 1 across the cone")
        .out<Float>("attenuation", attenuation_doc)
        .body([](DecalCone in) {
            const Axes axes = axes_of(-in.direction, in.up);
            const vec3 way = named("way", in.point - in.origin);
            const vec3 place = into(axes, way);
            const vec2 side = named("side", place.xy());
            const Float ahead = named("ahead", -place.z());
            const Float nearest = named("nearest // distance from the projector", Float(1e-6));
            const Float wide = named("wide", max(ahead, nearest) * tan(radians(in.angle) * 0.5));
            const vec2 across =
                named("across", side / wide);  // within the unit disc inside the cone
            const Float within = inside(length(across), in.edge) *
                                 inside(ahead / in.range, in.edge) * step(nearest, ahead);
            return std::tuple{across * 0.5 + vec2(0.5),
                              within * angle_fade(in.normal, -normalize(way), in.angle_fade)};
        }),

    decal_family(
        "decal_sphere", "Sphere decal",
        "Projects an image from a point to all sides: a cube map by direction, or by longitude "
        "and latitude.")
        .in<vec3>("point", surface::position, point_doc)
        .in<Normal>("normal", surface::normal, "Normal of the receiving surface, for the angle")
        .in<vec3>("origin", {0, 0, 1}, "The centre", slider(-2, 2))
        .in<vec3>("axis", {0, 1, 0}, "To the pole where v is 1; any length", slider(-1, 1))
        .in<vec3>("front", {0, 0, 1}, "Where u is 0.5; any length", slider(-1, 1))
        .in<Float>("radius", 0.5, "How far it reaches, in length units", slider(0.01, 4),
                   limits(1e-6, 1e6))
        .in<Float>("edge", 0.3, edge_doc, slider(0, 1), limits(0, 1))
        .in<Float>("angle_fade", 0,
                   "Exponent of the cosine between the surface and the way out of the ball: 0 "
                   "reaches every side",
                   slider(0, 4), limits(0, 64))
        .out<vec2>("uv", "Longitude and latitude, 0 to 1, as seen from outside")
        .out<vec3>("direction", "Out of the centre, in object space and length units")
        .out<Float>("attenuation", attenuation_doc)
        .body([](DecalSphere in) {
            const vec3 way = named("way", in.point - in.origin), out = normalize(way);
            const vec2 uv = longitude_latitude(round_place(way, in.axis, in.front));
            return std::tuple{uv, way,
                              inside(length(way) / in.radius, in.edge) *
                                  angle_fade(in.normal, out, in.angle_fade)};
        }),

    decal_family("decal_capsule", "Capsule decal",
                 "Projects an image from a line to all sides: a capsule.")
        .in<vec3>("point", surface::position, point_doc)
        .in<Normal>("normal", surface::normal, "Normal of the receiving surface, for the angle")
        .in<vec3>("start", {-0.4, 0, 1}, "One end of the line, v = 0", slider(-2, 2))
        .in<vec3>("end", {0.4, 0, 1}, "The other end, v = 1", slider(-2, 2))
        .in<vec3>("front", {0, 0, 1}, "Where u is 0.5; any length", slider(-1, 1))
        .in<Float>("radius", 0.4, "How far it reaches, in length units", slider(0.01, 4),
                   limits(1e-6, 1e6))
        .in<Float>("edge", 0.3, edge_doc, slider(0, 1), limits(0, 1))
        .in<Float>("angle_fade", 0,
                   "Exponent of the cosine between the surface and the way out of the line: 0 "
                   "reaches every side",
                   slider(0, 4), limits(0, 64))
        .out<vec2>("uv", "u once around, v from end to end; beyond the ends v stays")
        .out<vec3>("direction", "Out of the line, in object space and length units")
        .out<Float>("attenuation", attenuation_doc)
        .body([](DecalCapsule in) {
            const vec3 line = in.end - in.start, way = named("way", in.point - in.start);
            const Float ratio = named("ratio", divide(dot(way, line), dot(line, line)));
            const Float along = named("along", saturate(ratio));
            const vec3 off = named("off", way - line * along), out = normalize(off);
            const vec2 uv(turns_of(round_place(off, line, in.front)), along);
            return std::tuple{uv, off,
                              inside(length(off) / in.radius, in.edge) *
                                  angle_fade(in.normal, out, in.angle_fade)};
        }),

    decal_family("decal_add", "Add decal", "Lays a decal's bump over what is there.")
        .in<Gradient>("gradient", "The bump that is there")
        .in<Gradient>("decal", "The decal's bump")
        .in<Float>("attenuation", 1, attenuation_doc, slider(0, 1))
        .in<Float>("strength", 1, "Factor of the decal's slopes", slider(-2, 2), unit("x"))
        .out<Gradient>("gradient", "Both together")
        .body([](Gradient there, Gradient decal, Float attenuation, Float strength) {
            return there + decal * (attenuation * strength);
        }),

    decal_family("decal_mask", "Masked decal", "Puts a decal's bump in place of what is there.")
        .in<Gradient>("gradient", "The bump that is there")
        .in<Gradient>("decal", "The decal's bump")
        .in<Float>("attenuation", 1, attenuation_doc, slider(0, 1))
        .in<Float>("strength", 1, "Factor of the decal's slopes", slider(-2, 2), unit("x"))
        .out<Gradient>("gradient", "The decal where it arrives, else what is there")
        .body([](Gradient there, Gradient decal, Float attenuation, Float strength) {
            return mix(there, decal * strength, attenuation);
        })};
constinit std::span<Node> decal_nodes = decal_list;

}  // namespace wrinkle::nodes
