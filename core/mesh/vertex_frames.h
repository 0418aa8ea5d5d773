// Generates the vertex normals and tangents that a mesh lacks. Results are finite for any mesh.
#pragma once

#include <glm/vec3.hpp>

#include "mesh/mesh.h"

namespace wrinkle {

// Generates missing normals, normalises all, and replaces those that are zero or not finite.
// Returns the number of replaced normals.
//
// The normal of a position is the mean of the face normals of all corners at that position,
// weighted by corner angle, whichever vertices they belong to; uv seams are invisible. Faces
// without area do not contribute. A vertex without a face with area gets +z.
size_t complete_normals(Mesh& mesh);

// Replaces the tangents. Returns false and does nothing if the mesh has no normals or no uv0.
//
// The tangents are those of MikkTSpace (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited",
// 2008, section 3; www.mikktspace.com), for triangles and with the default angular threshold of 180
// degrees.
//
// Corners of equal position, normal and uv are welded. The tangent of a triangle is the direction
// of increasing u on it; its sign is that of its uv area. The corners at a welded vertex form
// groups of triangles connected by shared edges and with one sign; two triangles share an edge if
// they run along it in opposite directions. Each triangle of a group projects its tangent to the
// plane of the normal; the group's tangent is the mean of these, weighted by the corner angle in
// that plane. w is the group's sign. A vertex with different tangents at its corners is split, so
// indices and arrays may grow; the order of triangles is unchanged.
//
// A triangle without uv area joins a group of either sign and contributes nothing to it. A triangle
// with two corners at one position takes the tangent of another triangle at that welded vertex. If
// the mean cancels, each triangle uses its own projected tangent. Remaining corners get a unit
// vector perpendicular to the normal, and w = 1 if the sign is unknown (the reference uses
// (1, 0, 0), which may be parallel to the normal).
bool make_tangents(Mesh& mesh);

// Generates tangents if the mesh has uv0 and normals but no tangents; otherwise does nothing.
void ensure_tangents(Mesh& mesh);

glm::vec3 any_perpendicular(glm::dvec3 normal);  // unit; (1, 0, 0) for a zero normal

}  // namespace wrinkle
