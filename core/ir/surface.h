// The surface point's normal and its differentials: the expressions on which lowering and expansion
// must agree. All in object space.
#pragma once

#include "base/back_faces.h"
#include "ir/side_tables.h"

namespace wrinkle {

enum class Variant : uint8_t;

// The interpolated normal, normalized, without the back-face rule. Undefined for a zero normal:
// `eval` rejects it, meshes have none, and the struct of a generated function documents it.
Id unit_normal(Module& module);

// The normal that a graph reads: unit, multiplied by `facing` unless the rule is none.
Id surface_normal(Module& module, BackFaces back_faces);

// Returns true for unit_normal() and surface_normal() values, by the form of their expression.
bool is_surface_normal(const Module& module, Id id);

// Differential of the position to the next pixel, in its tangent plane: P - n (n.P).
Id projected_position(Module& module, Variant axis);

// n . (Px x Py): the area of a pixel on the tangent plane, of order (pixel size)^2; negative if the
// screen's x and y have the opposite orientation about the normal.
Id screen_area(Module& module);

}  // namespace wrinkle
