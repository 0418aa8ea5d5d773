// The surface point's normal and its differentials: the few expressions that lowering and expansion
// must agree on. All in object space.
#pragma once

#include "base/back_faces.h"
#include "ir/module.h"

namespace wrinkle {

// The interpolated normal made unit, without the back-face rule. A zero normal has no answer:
// `eval` refuses it, meshes have none, and the struct of a generated function says so.
Id unit_normal(Module& module);

// The normal that a graph sees: unit, turned by `facing` unless the rule is none.
Id surface_normal(Module& module, BackFaces back_faces);

// Whether the value is one of these two, by the way it is made.
bool is_surface_normal(const Module& module, Id id);

// The position's change to the next pixel, in its tangent plane: P - n (n.P).
Id projected_position(Module& module, Variant axis);

// n . (Px x Py): what a pixel covers of the tangent plane, negative where the screen's x and y turn
// the other way round the normal. An area of (pixel size)^2.
Id screen_area(Module& module);

}  // namespace wrinkle
