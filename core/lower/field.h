// Reading expressions at other places than the surface point. For core/lower alone.
#pragma once

#include "ir/module.h"

namespace wrinkle {

// `value` with the surface input `domain` replaced by `at`. Where `at` belongs to a loop or a
// function, each implicit sample that moves with it becomes a sample_grad with the differentials of
// the place where it stood, and ddx and ddy stay those of that place: the footprint is that of the
// surface point.
Id read_field(Module& module, Id value, SurfaceInput domain, Id at);

// An implicit sample written in a loop or a function: its differentials are those of uv with the
// loop's state held fixed; where uv is made of that state alone, those of uv0.
Id sample_inside(Module& module, uint32_t resource, Id uv);

}  // namespace wrinkle
