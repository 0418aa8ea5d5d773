// Forward derivatives: how a value changes along one direction.
//
// A direction says how the leaves change: for each leaf its tangent, of the same type; leaves not
// named are constant. The derivative is ordinary instructions of the same module. It is computed
// over a worklist with a memo, and zero is a sentinel that costs nothing, so derivatives of sparse
// expressions stay sparse. Rules at singular points stand above the op table. Opaque values have no
// derivative here: expand first. The derivative of a call is a call of the derived function; of a
// loop, a loop whose state is twice as wide, along the path that the loop takes. The derivative of
// a height texture is the reference's filtered one: forward differences over one texel of the level
// in use (Mikkelsen's DerivFromHeightMap, three taps), times the change of uv.
#pragma once

#include <unordered_map>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

class Direction {
public:
    explicit Direction(Module& module) : module_(&module) {}
    void seed(Id leaf, Id tangent);

    // The tangent of `value`; poison stands for zero (see tangent_or_zero). Memoised.
    Id tangent(Id value);
    Id tangent_or_zero(Id value);

private:
    Module* module_;
    std::unordered_map<Id, Id> memo_;
};

// The change to the next pixel, in x and in y: every interpolated input changes by its own
// differential (position's is projected on the tangent plane of the surface normal when
// `project_position`, so that a height of position equals its volume form on low-poly meshes too).
Direction screen_direction(Module& module, Variant axis, bool project_position);

// d/du or d/dv of a uv set: that set changes by (1,0) or (0,1), all else is constant.
Direction uv_direction(Module& module, SurfaceInput uv_set, int axis);

}  // namespace wrinkle
