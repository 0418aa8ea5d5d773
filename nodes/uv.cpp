// Texture coordinates: transformed, or from positions in space. As expressions of the position the
// latter have exact derivatives: a map read there gives the bump of the volume that the projection
// defines.
#include <span>

#include "nodes/projection.h"
#include "nodes/rotated.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto uv_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("uv");
}

enum class Axis { x, y, z };
enum class Side { both, positive, negative };

static Float along(vec3 v, Axis axis) {
    return axis == Axis::x ? v.x() : axis == Axis::y ? v.y() : v.z();
}
static vec2 plane(const Planes& planes, Axis axis) {
    return axis == Axis::x ? planes.x : axis == Axis::y ? planes.y : planes.z;
}

struct PlanarUv {
    vec3 point, normal;
    Axis axis;
    Side side;
    vec2 scale;
    Float limit, falloff;
};

static constinit Node uv_list[] = {
    uv_family("uv_transform", "UV transform",
              "A uv scaled, then turned about the origin, then moved.")
        .in<vec2>("uv", surface::uv0, "The uv to change")
        .in<vec2>("scale", 1, "How often a texture repeats per uv unit", slider(0, 16), unit("x"))
        .in<Float>("rotation", 0, "In degrees; the uv turns anticlockwise, textures clockwise",
                   slider(-180, 180), unit("deg"))
        .in<vec2>("offset", 0, "Added at the end, in uv units", slider(-1, 1))
        .out<vec2>("uv", "The changed uv")
        .body([](vec2 uv, vec2 scale, Float rotation, vec2 offset) {
            return rotated(uv * scale, radians(rotation)) + offset;
        }),

    uv_family("planar_uv", "Planar UV",
              "Projects along an axis. Nothing is mirrored: each side reads as seen from outside.")
        .in<vec3>("point", surface::position, point_doc)
        .in<Normal>("normal", surface::normal,
                    "Normal of the surface; selects the side and its weight")
        .choice("axis", axis_names, "The axis to look along", static_cast<int>(Axis::y))
        .choice("side", {"both", "positive", "negative"}, "The sides that the weight lets through")
        .in<vec2>("scale", 1, "Repeats per length unit", slider(0, 8), unit("x"))
        .in<Float>("limit", 0.2, "Cosine of the slant at which the weight is 0", slider(0, 1))
        .in<Float>("falloff", 0.3, "From there to weight 1, in cosine; 0 is a hard edge",
                   slider(0, 1), limits(0, 2))
        .out<vec2>("uv", "The projected place")
        .out<Float>("weight",
                    "0 to 1: how squarely the surface faces the chosen side; constant under "
                    "differentiation")
        .body([](PlanarUv in) {
            const Float towards = along(normalize(front_of(in.normal)), in.axis);
            const Float faced = in.side == Side::both       ? abs(towards)
                                : in.side == Side::positive ? towards
                                                            : -towards;
            const Float weight = smoothstep(in.limit, in.limit + in.falloff, detach(faced));
            const Planes planes = planes_at(in.point, side_of(front_of(in.normal)));
            return std::tuple{plane(planes, in.axis) * in.scale, detach(weight)};
        }),

    uv_family("plane_uv", "Plane UV",
              "Projects on any plane, as seen from its front: u to the right, v up.")
        .in<vec3>("point", surface::position, point_doc)
        .in<vec3>("origin", 0, "The place of uv (0, 0), in object space", slider(-2, 2))
        .in<vec3>("normal", {0, 0, 1}, "Out of the plane's front; any length", slider(-1, 1))
        .in<vec3>("up", {0, 1, 0}, "Where v grows, flattened onto the plane; any length",
                  slider(-1, 1))
        .in<vec2>("scale", 1, "Repeats per length unit", slider(0, 8), unit("x"))
        .out<vec2>("uv", "The projected place")
        .out<Float>("distance", "Before the plane, in length units; negative behind it")
        .body([](vec3 point, vec3 origin, vec3 normal, vec3 up, vec2 scale) {
            const vec3 place = into(axes_of(normal, up), point - origin);
            return std::tuple{place.xy() * scale, place.z()};
        }),

    uv_family("box_uv", "Box UV",
              "Projects along the axis that the normal is nearest to: six sides, none mirrored.")
        .in<vec3>("point", surface::position, point_doc)
        .in<vec3>("direction", surface::normal, "Chooses the side by its largest component")
        .in<vec2>("scale", 1, "Repeats per length unit", slider(0, 8), unit("x"))
        .out<vec2>("uv", "The projected place")
        .out<Float>("face", "The side: 0 to 5 for +x, -x, +y, -y, +z, -z")
        .body([](vec3 point, vec3 direction, vec2 scale) {
            const CubeFace face = cube_face(front_of(direction), point);
            return std::tuple{face.place * scale, face.index};
        }),

    uv_family("cylinder_uv", "Cylinder UV",
              "Wraps a texture round an axis: u once around, v along it in length units.")
        .in<vec3>("point", surface::position, point_doc)
        .in<vec3>("origin", 0, "A place on the axis, where v is 0", slider(-2, 2))
        .in<vec3>("axis", {0, 1, 0}, "Where v grows; any length", slider(-1, 1))
        .in<vec3>("front", {0, 0, 1}, "Where u is 0.5; the seam is behind", slider(-1, 1))
        .out<vec2>("uv",
                   "u from 0 to 1 around, to the right as seen from outside; v in length units")
        .out<Float>("radius", "Distance from the axis, in length units")
        .body([](vec3 point, vec3 origin, vec3 axis, vec3 front) {
            const vec3 place = round_place(point - origin, axis, front);
            return std::tuple{vec2(turns_of(place), place.y()), length(place.xz())};
        }),

    uv_family("sphere_uv", "Sphere UV",
              "Wraps a texture round a point: u by longitude, v by latitude.")
        .in<vec3>("point", surface::position, point_doc)
        .in<vec3>("origin", 0, "The centre", slider(-2, 2))
        .in<vec3>("axis", {0, 1, 0}, "To the pole where v is 1; any length", slider(-1, 1))
        .in<vec3>("front", {0, 0, 1}, "Where u is 0.5; the seam is behind", slider(-1, 1))
        .out<vec2>("uv",
                   "u from 0 to 1 around, to the right as seen from outside; v from pole to pole")
        .out<Float>("radius", "Distance from the centre, in length units")
        .body([](vec3 point, vec3 origin, vec3 axis, vec3 front) {
            const vec3 place = round_place(point - origin, axis, front);
            return std::tuple{longitude_latitude(place), length(place)};
        })};
constinit std::span<Node> uv_nodes = uv_list;

}  // namespace wrinkle::nodes
