// A triangle of uv set 0 as a map from a uv to the weights of its corners: what sample_mesh() and a
// bake read a mesh by, so that both get the same numbers to the last bit.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "mesh/mesh.h"

namespace wrinkle {

struct UvTriangle {
    glm::dvec2 first;          // uv of corner 0
    glm::dvec2 second, third;  // change of the weights of corners 1 and 2 per unit of u and v

    // They sum up to 1; all are at least 0 where the triangle covers the uv.
    glm::dvec3 weights(glm::dvec2 uv) const {
        const glm::dvec2 p = uv - first;
        const double s = second.x * p.x + second.y * p.y;
        const double t = third.x * p.x + third.y * p.y;
        return {1 - s - t, s, t};
    }
    glm::dvec3 du() const { return {-second.x - third.x, second.x, third.x}; }
    glm::dvec3 dv() const { return {-second.y - third.y, second.y, third.y}; }
};

// The mesh has uv0. Nothing for a triangle without area in uv.
bool has_uv_area(const Mesh& mesh, size_t triangle);
std::optional<UvTriangle> uv_triangle(const Mesh& mesh, size_t triangle);

// A value of the triangle's three corners by their weights.
template <class Result, class T>
Result blend(const T& a, const T& b, const T& c, const glm::dvec3& weights) {
    return Result(a) * weights.x + Result(b) * weights.y + Result(c) * weights.z;
}

}  // namespace wrinkle
