// Directional albedos of the lobes of the shaded view: the fraction of light that a white lobe
// reflects in total, by the cosine of the view direction and the roughness. They weight image-based
// light (Karis, "Real Shading in Unreal Engine 4", 2013) and conserve energy (Turquin, "Practical
// multiple scattering compensation for microfacet models", 2019).
#pragma once

#include <glm/vec4.hpp>
#include <vector>

namespace wrinkle::gpu {

// For GGX with height-correlated Smith masking and m = v.h, the integral over the hemisphere of
// the lobe times
//   x  1 - (1 - m)^5      so that x F0 + y F90 is the albedo under Schlick's Fresnel term
//   y  (1 - m)^5
//   z  m (1 - m)^6        the F82 term of metals (Hoffman 2023)
// and w, the albedo of fuzz (base/fuzz.h).
glm::vec4 albedo(double cosine, double roughness);

constexpr int albedo_side = 32;

// Returns albedo_side rows of albedo_side values: value i of row k is for the cosine t^2 with
// t = i / (albedo_side - 1), dense where the albedo bends, and the roughness k / (albedo_side - 1).
std::vector<glm::vec4> albedo_table();

}  // namespace wrinkle::gpu
