// Arithmetic on vectors and colors, and their components.
#include <span>

#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto vector_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("vector");
}

static constinit Node vector_list[] = {
    vector_family("combine_vec2", "Combine vec2", "A vector of two numbers.")
        .in<Float>("x", 0, "First component")
        .in<Float>("y", 0, "Second component")
        .out<vec2>("vector", "The vector")
        .body([](Float x, Float y) { return vec2(x, y); }),

    vector_family("combine_vec3", "Combine vec3", "A vector of three numbers.")
        .in<Float>("x", 0, "First component")
        .in<Float>("y", 0, "Second component")
        .in<Float>("z", 0, "Third component")
        .out<vec3>("vector", "The vector")
        .body([](Float x, Float y, Float z) { return vec3(x, y, z); }),

    vector_family("combine_vec4", "Combine vec4", "A vector of four numbers.")
        .in<Float>("x", 0, "First component")
        .in<Float>("y", 0, "Second component")
        .in<Float>("z", 0, "Third component")
        .in<Float>("w", 0, "Fourth component")
        .out<vec4>("vector", "The vector")
        .body([](Float x, Float y, Float z, Float w) { return vec4(x, y, z, w); }),

    vector_family("separate_vec2", "Separate vec2", "The components of a vector.")
        .in<vec2>("vector", 0, "The vector")
        .out<Float>("x", "First component")
        .out<Float>("y", "Second component")
        .body([](vec2 v) {
            return std::tuple{v.x(), v.y()};
        }),

    vector_family("separate_vec3", "Separate vec3", "The components of a vector.")
        .in<vec3>("vector", 0, "The vector")
        .out<Float>("x", "First component")
        .out<Float>("y", "Second component")
        .out<Float>("z", "Third component")
        .body([](vec3 v) {
            return std::tuple{v.x(), v.y(), v.z()};
        }),

    vector_family("separate_vec4", "Separate vec4", "The components of a vector.")
        .in<vec4>("vector", 0, "The vector")
        .out<Float>("x", "First component")
        .out<Float>("y", "Second component")
        .out<Float>("z", "Third component")
        .out<Float>("w", "Fourth component")
        .body([](vec4 v) {
            return std::tuple{v.x(), v.y(), v.z(), v.w()};
        }),

    vector_family("vec2_add", "Add vec2", "The sum of two vectors.")
        .in<vec2>("a", 0, "One vector")
        .in<vec2>("b", 0, "The other vector")
        .out<vec2>("vector", "a + b")
        .body([](vec2 a, vec2 b) { return a + b; }),

    vector_family("vec2_scale", "Scale vec2", "A vector made longer or shorter.")
        .in<vec2>("vector", 0, "The vector")
        .in<Float>("factor", 1, "Factor of its length", slider(-2, 2), unit("x"))
        .out<vec2>("vector", "The scaled vector")
        .body([](vec2 vector, Float factor) { return vector * factor; }),

    vector_family("vec3_add", "Add vec3", "The sum of two vectors.")
        .in<vec3>("a", 0, "One vector")
        .in<vec3>("b", 0, "The other vector")
        .out<vec3>("vector", "a + b")
        .body([](vec3 a, vec3 b) { return a + b; }),

    vector_family("vec3_subtract", "Subtract vec3", "The difference of two vectors.")
        .in<vec3>("a", 0, "The vector to take from")
        .in<vec3>("b", 0, "The vector to take away")
        .out<vec3>("vector", "a - b")
        .body([](vec3 a, vec3 b) { return a - b; }),

    vector_family("vec3_multiply", "Multiply vec3",
                  "The product of two vectors by components, as colors filter each other.")
        .in<vec3>("a", 1, "One vector")
        .in<vec3>("b", 1, "The other vector")
        .out<vec3>("vector", "a b")
        .body([](vec3 a, vec3 b) { return a * b; }),

    vector_family("vec3_scale", "Scale vec3", "A vector made longer or shorter.")
        .in<vec3>("vector", 0, "The vector")
        .in<Float>("factor", 1, "Factor of its length", slider(-2, 2), unit("x"))
        .out<vec3>("vector", "The scaled vector")
        .body([](vec3 vector, Float factor) { return vector * factor; }),

    vector_family("vec3_mix", "Mix vec3", "Goes from one vector or color to another.")
        .in<vec3>("a", 0, "The vector where the mask is 0")
        .in<vec3>("b", 1, "The vector where the mask is 1")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<vec3>("vector", "(1 - mask) a + mask b")
        .body([](vec3 a, vec3 b, Float mask) { return mix(a, b, mask); }),

    vector_family("dot", "Dot product",
                  "How far two vectors point the same way: the product of their lengths and the "
                  "cosine between them.")
        .in<vec3>("a", 0, "One vector")
        .in<vec3>("b", 0, "The other vector")
        .out<Float>("result", "a . b")
        .body([](vec3 a, vec3 b) { return dot(a, b); }),

    vector_family("cross", "Cross product", "A vector perpendicular to two others, right-handed.")
        .in<vec3>("a", {1, 0, 0}, "One vector")
        .in<vec3>("b", {0, 1, 0}, "The other vector")
        .out<vec3>("vector", "a x b")
        .body([](vec3 a, vec3 b) { return cross(a, b); }),

    vector_family("length", "Length", "The length of a vector.")
        .in<vec3>("vector", 0, "The vector")
        .out<Float>("result", "Not negative")
        .body([](vec3 vector) { return length(vector); }),

    vector_family("normalize", "Normalize", "The vector with length 1; a zero vector stays zero.")
        .in<vec3>("vector", {0, 0, 1}, "The vector")
        .out<vec3>("vector", "Unit or zero")
        .body([](vec3 vector) { return normalize(vector); }),

    vector_family("distance", "Distance", "The distance of two points.")
        .in<vec3>("a", 0, "One point")
        .in<vec3>("b", 0, "The other point")
        .out<Float>("result", "Not negative")
        .body([](vec3 a, vec3 b) { return distance(a, b); }),

    vector_family("vec3_minimum", "Minimum vec3", "The lesser components of two vectors.")
        .in<vec3>("a", 0, "One vector")
        .in<vec3>("b", 0, "The other vector")
        .out<vec3>("vector", "The lesser of each component")
        .body([](vec3 a, vec3 b) { return min(a, b); }),

    vector_family("vec3_maximum", "Maximum vec3", "The greater components of two vectors.")
        .in<vec3>("a", 0, "One vector")
        .in<vec3>("b", 0, "The other vector")
        .out<vec3>("vector", "The greater of each component")
        .body([](vec3 a, vec3 b) { return max(a, b); }),

    vector_family("vec3_floor", "Floor vec3", "The floor of each component; it has no bump.")
        .in<vec3>("vector", 0, "The vector")
        .out<vec3>("vector", "Whole numbers")
        .body([](vec3 vector) { return floor(vector); }),

    vector_family("vec3_fraction", "Fraction vec3", "Each component above its floor.")
        .in<vec3>("vector", 0, "The vector")
        .out<vec3>("vector", "0 to 1")
        .body([](vec3 vector) { return fract(vector); }),

    vector_family("vec3_absolute", "Absolute vec3", "Each component without its sign.")
        .in<vec3>("vector", 0, "The vector")
        .out<vec3>("vector", "Not negative")
        .body([](vec3 vector) { return abs(vector); }),

    vector_family("reflect", "Reflect", "A direction mirrored by a plane.")
        .in<vec3>("vector", {0, 0, -1}, "The direction, of any length")
        .in<vec3>("normal", {0, 0, 1}, "The normal of the plane, of any length")
        .out<vec3>("vector", "The mirrored direction, of the same length")
        .body([](vec3 vector, vec3 normal) { return reflect(vector, normalize(normal)); }),

    vector_family("refract", "Refract",
                  "A direction after it enters another medium; zero where all is reflected.")
        .in<vec3>("vector", {0, 0, -1}, "The direction towards the surface, of any length")
        .in<vec3>("normal", {0, 0, 1}, "The normal on the side it comes from, of any length")
        .in<Float>("ratio", 0.6667, "Index of refraction before over that after", slider(0.4, 2.5))
        .out<vec3>("vector", "Unit or zero")
        .body([](vec3 vector, vec3 normal, Float ratio) {
            const vec3 i = named("incident", normalize(vector)), n = named("n", normalize(normal));
            const Float cosine = named("cosine", dot(n, i));
            const Float square = named("square", 1 - ratio * ratio * (1 - cosine * cosine));
            const vec3 bent = ratio * i - (ratio * cosine + sqrt(square)) * n;
            return select(square >= 0, bent, vec3(0));
        }),

    vector_family("rotate", "Rotate", "A vector turned about an axis, anticlockwise.")
        .in<vec3>("vector", {1, 0, 0}, "The vector")
        .in<vec3>("axis", {0, 0, 1}, "The axis, of any length; about a zero axis it is unchanged")
        .in<Float>("angle", 0, "In degrees", slider(-180, 180), unit("deg"))
        .out<vec3>("vector", "The turned vector")
        .body([](vec3 vector, vec3 axis, Float angle) {
            const vec3 unit = named("unit", normalize(axis));
            const Float turn = named("turn", radians(select(dot(axis, axis) > 0, angle, 0)));
            const Float c = named("c", cos(turn));
            return c * vector + sin(turn) * cross(unit, vector) +
                   (1 - c) * dot(unit, vector) * unit;
        }),

    vector_family("project", "Project", "The part of a vector along another; zero along zero.")
        .in<vec3>("vector", 0, "The vector")
        .in<vec3>("onto", {0, 0, 1}, "The direction, of any length")
        .out<vec3>("vector", "Parallel to the direction")
        .body([](vec3 vector, vec3 onto) {
            return divide(dot(vector, onto), dot(onto, onto)) * onto;
        }),

    vector_family("face_forward", "Face forward",
                  "A vector, reversed where a reference points along another.")
        .in<vec3>("vector", {0, 0, 1}, "The vector")
        .in<vec3>("incident", {0, 0, -1}, "The direction towards the surface")
        .in<vec3>("reference", {0, 0, 1}, "Reverses the vector where it points along `incident`")
        .out<vec3>("vector", "The vector, or its opposite")
        .body([](vec3 vector, vec3 incident, vec3 reference) {
            return select(dot(reference, incident) < 0, vector, -vector);
        })};
constinit std::span<Node> vector_nodes = vector_list;

}  // namespace wrinkle::nodes
