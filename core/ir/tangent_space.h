// Normals in the tangent frame of uv0, as tangent-space normal maps store them. One definition for
// baked maps and for generated functions.
#pragma once

#include "ir/value.h"

namespace wrinkle {

// Returns the normal in the tangent frame: m with normal ~ m.x T + m.y B + m.z N, unit; (0, 0, 1)
// if the volume of the frame is zero. B points up in the image. The frame is that of the vertex
// tangents, or derived from the screen differentials of uv0.
Value in_tangent_space(Module& module, Value normal, bool vertex_tangents);

// Replaces each output of type normal by the normal in_tangent_space().
Module with_tangent_space_normals(Module module, bool vertex_tangents);

}  // namespace wrinkle
