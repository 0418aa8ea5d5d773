// Vertex tangents from uv0, in MikkTSpace's manner.
//
// A triangle's tangent is the direction of increasing u on it. Each corner projects it onto the
// plane of its own normal, and the corners that share a vertex are averaged, weighted by their
// angle. The sign w is the uv orientation of the triangle. A vertex whose triangles disagree in it
// is split in two, so indices and arrays may grow; the order of triangles stays.
//
// A triangle without area in uv or in space takes part in no average, except where a vertex has no
// other: there the tangent is some unit vector at right angles to the normal and w is +1. Results
// are finite for any finite mesh. Unlike the full algorithm, vertices are only shared where the
// mesh shares them.
#pragma once

#include "mesh/mesh.h"

namespace wrinkle {

// Replaces the tangents. Needs normals and uv0; without them it does nothing and returns false.
bool make_tangents(Mesh& mesh);

// Makes tangents where the mesh has uv0 and normals and none; else leaves the mesh alone.
void ensure_tangents(Mesh& mesh);

}  // namespace wrinkle
