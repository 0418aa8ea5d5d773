// Reads of textures and fields for a node's build(). Internal to core/lower.
#pragma once

#include "base/texture_options.h"
#include "ir/module.h"

namespace wrinkle {

// Returns the decoded vec4 of a sampled vec4, by arithmetic right after the sample; srgb has none
// unless the shader is its decoder. Alpha is unchanged, except that it is 1 for normal_rg and
// normal_ag.
Id decode(Module& module, const TextureOptions& options, Id texel);

// Returns `value` with the surface input `domain` replaced by `at`. If `at` belongs to a loop or a
// function, each implicit sample that depends on it becomes a sample_grad with the differentials of
// its original uv, and ddx and ddy are unchanged: the footprint is that of the surface point.
Id read_field(Module& module, Id value, SurfaceInput domain, Id at);

// Returns an implicit sample for a loop or a function: its differentials are those of uv with the
// loop's state constant; if uv depends on that state only, those of uv0.
Id sample_inside(Module& module, uint32_t resource, Id uv);

}  // namespace wrinkle
