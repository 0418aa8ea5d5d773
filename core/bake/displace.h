// A mesh moved by a height, for the preview of a displacement.
#pragma once

#include <span>
#include <string>

#include "cpu/evaluate.h"
#include "mesh/mesh.h"

namespace wrinkle {

// What a program reads at each vertex: its attributes, seen from straight above and in front. dx
// and dy are their changes along the first two edges of one triangle of the vertex, so textures are
// filtered to the size of triangles. An attribute that the mesh lacks stays empty.
PointSet vertex_points(const Mesh& mesh, const Program& program);

// Fills mesh.displaced: each vertex goes out along its normal by the program's output of this
// index, a height in length units of object space. Vertices at one place, as along seams and hard
// edges, go to one place. "" or what is wrong: the program reads something that the mesh lacks, or
// a height is not finite.
std::string displace(Mesh& mesh, const Program& program, size_t output,
                     std::span<const Texture> textures);

}  // namespace wrinkle
