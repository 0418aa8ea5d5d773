// Meshes moved and put together.
#pragma once

#include <glm/mat4x4.hpp>

#include "mesh/mesh.h"

namespace wrinkle {

// Positions by M, normals by cof(M) and its sign, tangents by M; where M mirrors, triangles and
// tangent.w turn round, so that outside stays outside. A normal or tangent that M makes zero stays.
void transform(Mesh& mesh, const glm::dmat4& m);

// Afterwards the mesh has every attribute that one of the two had; the other's vertices get uv
// (0, 0), colour white, and a tangent at right angles to their normal with w = 1.
void append(Mesh& mesh, const Mesh& part);

}  // namespace wrinkle
