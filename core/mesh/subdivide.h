// Finer triangles for the same surface.
//
// Every edge that is longer than `longest` is cut in its middle, again and again; what is there in
// the middle is the mean of both ends, normals and tangents made unit. Whether an edge is cut
// depends on its two ends alone, so triangles that share an edge, or lie on both sides of a uv
// seam, go on fitting. The shape stays: facets stay flat.
#pragma once

#include "mesh/mesh.h"

namespace wrinkle {

// Stops before the mesh has more triangles than `most`; longest <= 0 and NaN leave it alone.
Mesh subdivided(Mesh mesh, float longest, size_t most = 1'000'000);

}  // namespace wrinkle
