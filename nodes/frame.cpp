// Tangent frames as values: their vectors, a tangent from a map, a normal that faces the viewer.
#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

// The frames whose vectors exist apart from a slope, in the order of FrameMethod.
#define VECTOR_FRAMES \
    { "auto", "vertex", "derived" }

static vec3 along(vec2 way, vec2 uv, FrameMethod method) {
    const Frame basis = frame(uv, method, Scale::unit, surface::normal);
    return Gradient(Derivative(way, basis)).vector();
}

Node tangent_frame_node =
    node("tangent_frame", "Tangent frame",
         "The vectors along which a texture's u and v run on the surface, mirrored where the uv is "
         "mirrored.")
        .family("normal")
        .in<vec2>("uv", surface::uv0, "The uv whose directions are meant")
        .choice("frame", VECTOR_FRAMES, "The vertex tangent of uv0, or derived from the uv")
        .out<vec3>("tangent", "Along u, object space; unit but for a scaled vertex tangent")
        .out<vec3>("bitangent", "Along v, object space")
        .body([](vec2 uv, FrameMethod method) {
            return std::tuple{along(vec2(1, 0), uv, method), along(vec2(0, 1), uv, method)};
        });

enum class DirectionSpace { tangent, object };

Node tangent_map_node =
    node("tangent_map", "Tangent map",
         "A direction along the surface from a picture: the tangent of brushed metal or combed "
         "hair. Wire it to the `direction` of a map whose frame is `guess`.")
        .family("normal")
        .in<Image>("image", "Directions: x in red, y in green, z in blue; 0.5 is 0",
                   encoding("normal_gl"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .choice("space", {"tangent", "object"},
                "Whether the picture holds directions along u and v, or of object space")
        .choice("frame", VECTOR_FRAMES,
                "What u and v are: the vertex tangent of uv0, or derived from the uv")
        .out<vec3>("direction", "Object space, any length; its part along the surface counts")
        .body([](Image image, vec2 uv, DirectionSpace space, FrameMethod method) {
            const vec3 read = image.sample(uv).xyz();
            return space == DirectionSpace::object ? read : along(read.xy(), uv, method);
        });

Node face_viewer_node =
    node("face_viewer", "Face the viewer",
         "A normal that a steep bump turned away from the viewer, mirrored back; others pass.")
        .family("normal")
        .in<Normal>("normal", surface::normal, "Unit normal in object space")
        .in<vec3>("view", surface::view, "Unit direction to the eye, object space")
        .out<Normal>("normal", "Unit normal, never turned away from the eye")
        .body([](vec3 normal, vec3 view) { return normal - 2 * min(dot(normal, view), 0) * view; });

}  // namespace wrinkle::nodes
