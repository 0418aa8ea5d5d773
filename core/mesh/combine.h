// Transforms and appends meshes.
#pragma once

#include <glm/mat4x4.hpp>

#include "mesh/mesh.h"

namespace wrinkle {

// Transforms positions by M, normals by cof(M) times the sign of det(M), tangents by M. If M
// mirrors, the corner order of triangles and tangent.w are reversed, so that the outside stays
// outside. Normals and tangents that M maps to zero are unchanged.
void transform(Mesh& mesh, const glm::dmat4& m);

// Appends `part` to `mesh`. The result has every attribute that at least one of them has; vertices
// that lack it get uv (0, 0), white, or a tangent perpendicular to their normal with w = 1.
void append(Mesh& mesh, const Mesh& part);

}  // namespace wrinkle
