// Vertex tangents from uv0: MikkTSpace (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
// 2008, section 3; www.mikktspace.com), with triangles and the customary angular threshold of 180
// degrees.
//
// Corners of equal position, normal and uv are one place, whatever vertices they belong to. A
// triangle's tangent is the direction of increasing u on it, its sign that of its uv area. The
// corners at a place fall into groups: triangles reached from each other over the edges they share,
// with one sign; two triangles share an edge when they run along it in opposite directions. In a
// group each triangle projects its tangent on the plane of the normal, and the group's tangent is
// the mean of these, weighted by the angle of the corner in that plane. w is the group's sign. A
// vertex whose corners get different tangents is split, so indices and arrays may grow; the order
// of triangles stays.
//
// A triangle without uv area joins a group of either sign and adds nothing to it. One that has two
// corners in one point takes the tangent that another triangle has at that place. What is left
// over, or cancels, gets a unit vector at right angles to the normal, and w = 1 where no sign is
// known. (There the reference says (1, 0, 0), which may lie along the normal.) Results are finite
// for any mesh.
#pragma once

#include <glm/vec3.hpp>

#include "mesh/mesh.h"

namespace wrinkle {

// Replaces the tangents. Needs normals and uv0; without them it does nothing and returns false.
bool make_tangents(Mesh& mesh);

// Makes tangents where the mesh has uv0 and normals and none; else leaves the mesh alone.
void ensure_tangents(Mesh& mesh);

glm::vec3 any_perpendicular(glm::dvec3 normal);  // unit; (1, 0, 0) for no normal

}  // namespace wrinkle
