// Tangent frames as values: their vectors, a tangent from a map, a normal in tangent space, and a
// normal that faces the viewer.
#include <span>

#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto normal_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("normal");
}

// Frame methods that define vectors independently of a slope, in the order of FrameMethod.
constexpr const char* vector_frames[] = {"auto", "vertex", "derived"};

static vec3 along(vec2 way, Frame basis, Base base = {}) {
    return Gradient(Derivative(way, basis), base).vector();
}

static Frame unit_frame(vec2 uv, FrameMethod method) {
    return frame(uv, method, Scale::unit, surface::normal);
}

enum class DirectionSpace { tangent, object };

// Applies the inverse of [T B N] by cofactors. A positive factor does not change the direction, so
// only the sign of the determinant is used.
static vec3 into_frame(vec3 v, vec3 t, vec3 b, vec3 n) {
    const vec3 up = cross(t, b);
    const vec3 m =
        vec3(dot(cross(b, n), v), dot(cross(n, t), v), dot(up, v)) * sign_nonzero(dot(up, n));
    return select(dot(m, m) > 0, normalize(m), vec3(0, 0, 1));
}

static constinit Node frame_list[] = {
    normal_family(
        "tangent_frame", "Tangent frame",
        "The vectors along which a texture's u and v run on the surface, mirrored where the uv is "
        "mirrored.")
        .in<vec2>("uv", surface::uv0, "The uv whose directions are meant")
        .choice("frame", vector_frames, "The vertex tangent of uv0, or derived from the uv")
        .out<vec3>("tangent", "Along u, object space; unit but for a scaled vertex tangent")
        .out<vec3>("bitangent", "Along v, object space")
        .body([](vec2 uv, FrameMethod method) {
            const Frame basis = unit_frame(uv, method);
            return std::tuple{along(vec2(1, 0), basis), along(vec2(0, 1), basis)};
        }),

    normal_family(
        "tangent_map", "Tangent map",
        "A direction along the surface from an image: the tangent of brushed metal or combed "
        "hair. Wire it to the `direction` of a map whose frame is `guess`.")
        .in<Image>("image", "Directions: x in red, y in green, z in blue; 0.5 is 0",
                   encoding("normal_gl"))
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .choice("space", {"tangent", "object"},
                "Space of the image: directions along u and v, or object space")
        .choice("frame", vector_frames,
                "Directions of u and v: the vertex tangent of uv0, or derived from the uv")
        .out<vec3>("direction", "Object space, any length; its part along the surface counts")
        .body([](Image image, vec2 uv, DirectionSpace space, FrameMethod method) {
            const vec3 read = image.sample(uv).xyz();
            return space == DirectionSpace::object ? read
                                                   : along(read.xy(), unit_frame(uv, method));
        }),

    normal_family("tangent_space_normal", "Normal in tangent space",
                  "The texel of a tangent-space normal map for this normal or bump: decoded in the "
                  "same frame, on the same base, it is that normal again.")
        .in<Normal>("normal", surface::normal, "A resolved normal, object space, any length")
        .in<vec2>("uv", surface::uv0, "The uv along whose directions x and y are measured")
        .choice("scale", scales, scale_doc, static_cast<int>(Scale::unit))
        .choice("frame", frame_methods, frame_doc)
        .in<vec3>("direction", {0, 1, 0}, direction_doc)
        .in<Normal>("base", surface::normal, "The normal that the map will be put on")
        .out<vec3>("normal", "Unit, z outward, green up; (0, 0, 1) where the frame is degenerate")
        .out<Color>("color", "The same as a map stores it, 0.5 + 0.5 times the normal")
        .body([](vec3 wanted, vec2 uv, Scale scale, FrameMethod method, vec3 direction,
                 vec3 base_normal) {
            const Frame basis = frame(uv, method, scale, direction);
            const Base base(base_normal);
            const vec3 normal = into_frame(wanted, along(vec2(1, 0), basis, base),
                                           along(vec2(0, 1), basis, base), base_normal);
            return std::tuple{normal, 0.5 + 0.5 * normal};
        }),

    normal_family(
        "face_viewer", "Face the viewer",
        "A normal that a steep bump turned away from the viewer, mirrored back; others pass.")
        .in<Normal>("normal", surface::normal, "Unit normal in object space")
        .in<vec3>("view", surface::view, "Unit direction to the eye, object space")
        .out<Normal>("normal", "Unit normal, never turned away from the eye")
        .body(
            [](vec3 normal, vec3 view) { return normal - 2 * min(dot(normal, view), 0) * view; })};
constinit std::span<Node> frame_nodes = frame_list;

}  // namespace wrinkle::nodes
