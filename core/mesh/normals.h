// Smooth vertex normals.
//
// The normal of a position is the mean of the face normals of all corners at that position,
// weighted by corner angle, whichever vertices they belong to; uv seams are invisible. Faces
// without area do not contribute. A vertex without a face with area gets +z.
#pragma once

#include "mesh/mesh.h"

namespace wrinkle {

// Generates missing normals, normalises all, and replaces those that are zero or not finite.
// Returns the number of replaced normals.
size_t complete_normals(Mesh& mesh);

}  // namespace wrinkle
