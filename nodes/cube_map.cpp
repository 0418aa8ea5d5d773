// Cube maps: textures looked up by a direction.
//
// The six faces are stored in one image: as a `strip`, +x -x +y -y +z -z from left to right, or as
// a `grid` of three by two, +x -x +y above -y +z -z. Each face is oriented as seen from outside the
// cube, y up; for +y, -z is up, and for -y, +z is up. This is the order and orientation of OpenGL's
// cube maps.
#include <span>

#include "nodes/ports.h"
#include "nodes/projection.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class Arrangement { strip, grid };

// Faces do not bleed into each other: the lookup is clamped to half a texel inside the face, for a
// mip level up to twice as coarse as the footprint.
static vec4 read_cube(Image image, Arrangement arrangement, vec3 direction) {
    const CubeFace face = cube_face(direction, direction);
    const bool strip = arrangement == Arrangement::strip;
    const vec2 faces = strip ? vec2(6, 1) : vec2(3, 2);
    const Float width = named("width", 2 * (face.depth + Float(face.depth == 0)));
    const vec2 place = named("place", face.place / width + vec2(0.5));
    const vec2 column_row = strip ? vec2(face.index, 0)
                                  : vec2(select(face.index < 2.5, face.index, face.index - 3),
                                         select(face.index < 2.5, 1.0, 0.0));
    const vec2 size = named("face_size", image.size() / faces);
    const vec2 x = ddx(place), y = ddy(place);
    const Float extent = named("extent", max(length(x * size), length(y * size)));
    const Float footprint = named("footprint", max(extent, 0.5));
    // Limits the footprint to a face: in the coarsest usable level a face is one texel.
    const Float least = named("limit", min(min(size.x(), size.y()) / footprint, 1));
    const vec2 border = named("border", min(footprint / size, vec2(0.5)));
    const vec2 inside = named("inside", min(max(place, border), vec2(1) - border));
    return image.sample_grad(named("at", (inside + column_row) / faces),
                             named("at_dx", x * least / faces), named("at_dy", y * least / faces));
}

static constinit Node cube_map_list[] = {
    image_family("cube_normal_map", "Cube normal map",
                 "A bump from a cube map of object-space normals, looked up by a direction.")
        .in<Image>("image", "Object-space normals, any length, in six faces of a power of two",
                   encoding("normal_gl"))
        .in<vec3>("direction", surface::position, "Where to look, from the centre; any length")
        .choice("arrangement", {"strip", "grid"},
                "The faces of the image: +x -x +y -y +z -z in a row, or +x -x +y above -y +z -z")
        .in<Float>("strength", 1, strength_doc, slider(-2, 2), unit("x"))
        .in<Normal>("base", surface::normal, base_doc)
        .out<Gradient>("gradient", "The bump that leads to these normals")
        .out<vec3>(
            "volume",
            "The gradient in object space that turns the direction itself into these "
            "normals: what a sphere round the origin lends to other surfaces; limited to 128")
        .body([](Image image, vec3 direction, Arrangement arrangement, Float strength, vec3 base) {
            const vec3 normal = read_cube(image, arrangement, direction).xyz();
            const vec3 out = named("out", normalize(direction));
            const Float outward = named("outward", dot(out, normal));
            // As in tangent-space maps.
            const Float min_ratio = named("min_ratio // slopes are at most 128", Float(1.0 / 128));
            const Float min_length = named("min_length // of a normal", Float(1e-6));
            const Float steepest = max(length(normal) * min_ratio, min_length);
            const vec3 volume = (out * outward - normal) / max(abs(outward), steepest) * strength;
            return std::tuple{gradient_from_normal(normal, Base(base)) * strength, volume};
        })};
constinit std::span<Node> cube_map_nodes = cube_map_list;

}  // namespace wrinkle::nodes
