// Subdivides triangles without changing the surface.
//
// Every edge longer than `longest` is split at its midpoint, repeatedly. Midpoint attributes are
// the mean of both ends; normals and tangents are normalised. The split depends only on the two
// ends of an edge, so triangles that share an edge or a uv seam still match. Facets stay flat.
#pragma once

#include "mesh/mesh.h"

namespace wrinkle {

// Stops before the mesh has more than `most` triangles. longest <= 0 or NaN: returns the mesh
// unchanged.
Mesh subdivided(Mesh mesh, float longest, size_t most = 1'000'000);

}  // namespace wrinkle
