// Maps a uv to the barycentric weights of a triangle in uv set 0. sample_mesh() and the baker share
// it, so their results are bit-identical.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "mesh/mesh.h"

namespace wrinkle {

struct UvTriangle {
    glm::dvec2 first;          // uv of corner 0
    glm::dvec2 second, third;  // derivatives of the weights of corners 1 and 2 by (u, v)

    // The weights sum to 1; all are >= 0 if the triangle covers the uv.
    glm::dvec3 weights(glm::dvec2 uv) const {
        const glm::dvec2 p = uv - first;
        const double s = second.x * p.x + second.y * p.y;
        const double t = third.x * p.x + third.y * p.y;
        return {1 - s - t, s, t};
    }
    glm::dvec3 du() const { return {-second.x - third.x, second.x, third.x}; }
    glm::dvec3 dv() const { return {-second.y - third.y, second.y, third.y}; }
};

// Precondition: the mesh has uv0. uv_triangle() returns std::nullopt for a triangle without uv
// area.
bool has_uv_area(const Mesh& mesh, size_t triangle);
std::optional<UvTriangle> uv_triangle(const Mesh& mesh, size_t triangle);

// Interpolates a value of the three corners by their weights.
template <class Result, class T>
Result blend(const T& a, const T& b, const T& c, const glm::dvec3& weights) {
    return Result(a) * weights.x + Result(b) * weights.y + Result(c) * weights.z;
}

}  // namespace wrinkle
