// Smooth vertex normals.
//
// The normal of a position is the mean of the normals of the corners there, weighted by their
// angle, whatever vertices they belong to; so a uv seam stays invisible. Faces without area have no
// say. A vertex without a face that has area gets +z.
#pragma once

#include "mesh/mesh.h"

namespace wrinkle {

// Makes normals where the mesh has none, makes all unit, and replaces those that are zero or not
// finite. Returns how many of those there were.
size_t complete_normals(Mesh& mesh);

}  // namespace wrinkle
