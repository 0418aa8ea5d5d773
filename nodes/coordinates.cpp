// Texture coordinates from positions in space. As expressions of the position they have exact
// derivatives: a map read there gives the bump of the volume that the projection defines.
#include "nodes/projection.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

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

Node planar_uv_node =
    node("planar_uv", "Planar UV",
         "Projects along an axis. Nothing is mirrored: each side reads as seen from outside.")
        .family("uv")
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<Normal>("normal", surface::normal, "Tells which side is met, and how squarely")
        .choice("axis", AXES, "The axis to look along", static_cast<int>(Axis::y))
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
        });

struct PlaneUv {
    vec3 point, origin, normal, up;
    vec2 scale;
};

Node plane_uv_node =
    node("plane_uv", "Plane UV",
         "Projects on any plane, as seen from its front: u to the right, v up.")
        .family("uv")
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<vec3>("origin", 0, "The place of uv (0, 0), in object space", slider(-2, 2))
        .in<vec3>("normal", {0, 0, 1}, "Out of the plane's front; any length", slider(-1, 1))
        .in<vec3>("up", {0, 1, 0}, "Where v grows, flattened onto the plane; any length",
                  slider(-1, 1))
        .in<vec2>("scale", 1, "Repeats per length unit", slider(0, 8), unit("x"))
        .out<vec2>("uv", "The projected place")
        .out<Float>("distance", "Before the plane, in length units; negative behind it")
        .body([](PlaneUv in) {
            const vec3 place = into(axes_of(in.normal, in.up), in.point - in.origin);
            return std::tuple{place.xy() * in.scale, place.z()};
        });

Node box_uv_node =
    node("box_uv", "Box UV",
         "Projects along the axis that the normal is nearest to: six sides, none mirrored.")
        .family("uv")
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<vec3>("direction", surface::normal, "Chooses the side by its largest component")
        .in<vec2>("scale", 1, "Repeats per length unit", slider(0, 8), unit("x"))
        .out<vec2>("uv", "The projected place")
        .out<Float>("face", "The side: 0 to 5 for +x, -x, +y, -y, +z, -z")
        .body([](vec3 point, vec3 direction, vec2 scale) {
            const CubeFace face = cube_face(front_of(direction), point);
            return std::tuple{face.place * scale, face.index};
        });

struct RoundUv {
    vec3 point, origin, axis, front;
};
Node cylinder_uv_node =
    node("cylinder_uv", "Cylinder UV",
         "Wraps a texture round an axis: u once around, v along it in length units.")
        .family("uv")
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<vec3>("origin", 0, "A place on the axis, where v is 0", slider(-2, 2))
        .in<vec3>("axis", {0, 1, 0}, "Where v grows; any length", slider(-1, 1))
        .in<vec3>("front", {0, 0, 1}, "Where u is 0.5; the seam is behind", slider(-1, 1))
        .out<vec2>("uv",
                   "u from 0 to 1 around, to the right as seen from outside; v in length units")
        .out<Float>("radius", "Distance from the axis, in length units")
        .body([](RoundUv in) {
            const vec3 place = round_place(in.point - in.origin, in.axis, in.front);
            return std::tuple{vec2(turns_of(place), place.y()), length(place.xz())};
        });

Node sphere_uv_node =
    node("sphere_uv", "Sphere UV", "Wraps a texture round a point: u by longitude, v by latitude.")
        .family("uv")
        .in<vec3>("point", surface::position, POINT_DOC)
        .in<vec3>("origin", 0, "The centre", slider(-2, 2))
        .in<vec3>("axis", {0, 1, 0}, "To the pole where v is 1; any length", slider(-1, 1))
        .in<vec3>("front", {0, 0, 1}, "Where u is 0.5; the seam is behind", slider(-1, 1))
        .out<vec2>("uv",
                   "u from 0 to 1 around, to the right as seen from outside; v from pole to pole")
        .out<Float>("radius", "Distance from the centre, in length units")
        .body([](RoundUv in) {
            const vec3 place = round_place(in.point - in.origin, in.axis, in.front);
            return std::tuple{longitude_latitude(place), length(place)};
        });

}  // namespace wrinkle::nodes
