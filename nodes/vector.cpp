// Arithmetic on vectors and colours, and their components.
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

Node combine_vec2_node = node("combine_vec2", "Combine vec2", "A vector of two numbers.")
                             .family("vector")
                             .in<Float>("x", 0, "First component")
                             .in<Float>("y", 0, "Second component")
                             .out<vec2>("vector", "The vector")
                             .body([](Float x, Float y) { return vec2(x, y); });

Node combine_vec3_node = node("combine_vec3", "Combine vec3", "A vector of three numbers.")
                             .family("vector")
                             .in<Float>("x", 0, "First component")
                             .in<Float>("y", 0, "Second component")
                             .in<Float>("z", 0, "Third component")
                             .out<vec3>("vector", "The vector")
                             .body([](Float x, Float y, Float z) { return vec3(x, y, z); });

Node combine_vec4_node =
    node("combine_vec4", "Combine vec4", "A vector of four numbers.")
        .family("vector")
        .in<Float>("x", 0, "First component")
        .in<Float>("y", 0, "Second component")
        .in<Float>("z", 0, "Third component")
        .in<Float>("w", 0, "Fourth component")
        .out<vec4>("vector", "The vector")
        .body([](Float x, Float y, Float z, Float w) { return vec4(x, y, z, w); });

Node separate_vec2_node = node("separate_vec2", "Separate vec2", "The components of a vector.")
                              .family("vector")
                              .in<vec2>("vector", 0, "The vector")
                              .out<Float>("x", "First component")
                              .out<Float>("y", "Second component")
                              .body([](vec2 v) {
                                  return std::tuple{v.x(), v.y()};
                              });

Node separate_vec3_node = node("separate_vec3", "Separate vec3", "The components of a vector.")
                              .family("vector")
                              .in<vec3>("vector", 0, "The vector")
                              .out<Float>("x", "First component")
                              .out<Float>("y", "Second component")
                              .out<Float>("z", "Third component")
                              .body([](vec3 v) {
                                  return std::tuple{v.x(), v.y(), v.z()};
                              });

Node separate_vec4_node = node("separate_vec4", "Separate vec4", "The components of a vector.")
                              .family("vector")
                              .in<vec4>("vector", 0, "The vector")
                              .out<Float>("x", "First component")
                              .out<Float>("y", "Second component")
                              .out<Float>("z", "Third component")
                              .out<Float>("w", "Fourth component")
                              .body([](vec4 v) {
                                  return std::tuple{v.x(), v.y(), v.z(), v.w()};
                              });

Node vec2_add_node = node("vec2_add", "Add vec2", "The sum of two vectors.")
                         .family("vector")
                         .in<vec2>("a", 0, "One vector")
                         .in<vec2>("b", 0, "The other vector")
                         .out<vec2>("vector", "a + b")
                         .body([](vec2 a, vec2 b) { return a + b; });

Node vec2_scale_node = node("vec2_scale", "Scale vec2", "A vector made longer or shorter.")
                           .family("vector")
                           .in<vec2>("vector", 0, "The vector")
                           .in<Float>("factor", 1, "Factor of its length", slider(-2, 2), unit("x"))
                           .out<vec2>("vector", "The scaled vector")
                           .body([](vec2 vector, Float factor) { return vector * factor; });

Node vec3_add_node = node("vec3_add", "Add vec3", "The sum of two vectors.")
                         .family("vector")
                         .in<vec3>("a", 0, "One vector")
                         .in<vec3>("b", 0, "The other vector")
                         .out<vec3>("vector", "a + b")
                         .body([](vec3 a, vec3 b) { return a + b; });

Node vec3_subtract_node = node("vec3_subtract", "Subtract vec3", "The difference of two vectors.")
                              .family("vector")
                              .in<vec3>("a", 0, "The vector to take from")
                              .in<vec3>("b", 0, "The vector to take away")
                              .out<vec3>("vector", "a - b")
                              .body([](vec3 a, vec3 b) { return a - b; });

Node vec3_multiply_node =
    node("vec3_multiply", "Multiply vec3",
         "The product of two vectors by components, as colours filter each other.")
        .family("vector")
        .in<vec3>("a", 1, "One vector")
        .in<vec3>("b", 1, "The other vector")
        .out<vec3>("vector", "a b")
        .body([](vec3 a, vec3 b) { return a * b; });

Node vec3_scale_node = node("vec3_scale", "Scale vec3", "A vector made longer or shorter.")
                           .family("vector")
                           .in<vec3>("vector", 0, "The vector")
                           .in<Float>("factor", 1, "Factor of its length", slider(-2, 2), unit("x"))
                           .out<vec3>("vector", "The scaled vector")
                           .body([](vec3 vector, Float factor) { return vector * factor; });

Node vec3_mix_node = node("vec3_mix", "Mix vec3", "Goes from one vector or colour to another.")
                         .family("vector")
                         .in<vec3>("a", 0, "The vector where the mask is 0")
                         .in<vec3>("b", 1, "The vector where the mask is 1")
                         .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
                         .out<vec3>("vector", "(1 - mask) a + mask b")
                         .body([](vec3 a, vec3 b, Float mask) { return mix(a, b, mask); });

Node dot_node = node("dot", "Dot product",
                     "How far two vectors point the same way: the product of their lengths and the "
                     "cosine between them.")
                    .family("vector")
                    .in<vec3>("a", 0, "One vector")
                    .in<vec3>("b", 0, "The other vector")
                    .out<Float>("result", "a . b")
                    .body([](vec3 a, vec3 b) { return dot(a, b); });

Node cross_node =
    node("cross", "Cross product", "A vector perpendicular to two others, right-handed.")
        .family("vector")
        .in<vec3>("a", {1, 0, 0}, "One vector")
        .in<vec3>("b", {0, 1, 0}, "The other vector")
        .out<vec3>("vector", "a x b")
        .body([](vec3 a, vec3 b) { return cross(a, b); });

Node length_node = node("length", "Length", "The length of a vector.")
                       .family("vector")
                       .in<vec3>("vector", 0, "The vector")
                       .out<Float>("result", "Not negative")
                       .body([](vec3 vector) { return length(vector); });

Node normalize_node =
    node("normalize", "Normalize", "The vector with length 1; a zero vector stays zero.")
        .family("vector")
        .in<vec3>("vector", {0, 0, 1}, "The vector")
        .out<vec3>("vector", "Unit or zero")
        .body([](vec3 vector) { return normalize(vector); });

}  // namespace wrinkle::nodes
