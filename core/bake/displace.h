// Displaces a mesh by a height, for the preview of a displacement.
#pragma once

#include <span>
#include <string>

#include "cpu/evaluate.h"
#include "mesh/mesh.h"

namespace wrinkle {

// Returns the program's inputs at each vertex: its attributes, viewed along the normal from the
// front. dx and dy are differences along the two edges from the vertex in one of its triangles, so
// textures are filtered to the size of triangles. Attributes that the mesh lacks stay empty.
PointSet vertex_points(const Mesh& mesh, const Program& program);

// Fills mesh.displaced: moves each vertex along its normal by output `output` of the program, a
// height in length units of object space. Vertices at equal positions (seams, hard edges) move to
// their mean. Returns "", or the problem: no normals, the program reads an attribute that the mesh
// lacks, or a height is not finite.
std::string displace(Mesh& mesh, const Program& program, size_t output,
                     std::span<const Texture> textures);

}  // namespace wrinkle
