// GLSL of the two lighting models of the shaded view. Each text defines
//     vec3 WrView_lit(WrView_Surface s, vec3 v)
// the linear radiance towards the unit vector v; directions are in world space.
//
// ggx is OpenPBR Surface 1.1 as a mixture of lobes with albedo scaling (its section "Reduction").
// Diffuse: EON (Portsmouth, Kutz and Hill 2025);
// metal: F82 (Hoffman 2023); fuzz: a diffuse lobe with the albedo of OpenPBR's (base/fuzz.h);
// subsurface: a diffuse lobe with a normal that is flatter per channel (Ma et al. 2007), without
// subsurface_radius. Not shown: transmission, thin film, thin walls, anisotropy of the coat.
#pragma once

#include <string>
#include <string_view>

#include "gpu/surface_values.h"

namespace wrinkle::gpu {

std::string ggx_text(SurfaceModel model);
std::string_view phong_text();

}  // namespace wrinkle::gpu
