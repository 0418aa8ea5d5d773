// Parameters of a baked material in the models that most hosts share (glTF 2.0 with the Khronos
// extensions, Disney's), computed from those of OpenPBR Surface 1.1.
#pragma once

#include "export/baked_material.h"

namespace wrinkle {

// Linear: base_weight * base_color, and below a coat times coat_color, its transmittance at
// normal incidence, and times the darkening by reflections inside it (OpenPBR 1.1, section "Coat"),
// for hosts with colorless coats. The outputs that it depends on: base_color_outputs().
std::array<float, 3> host_base_color(const BakedMaterial& material, size_t texel);
std::initializer_list<std::string_view> base_color_outputs(const BakedMaterial& material);

// Radiance: emission_color times luminance in units of nits_of_unit_emission.
std::array<float, 3> host_emission(const BakedMaterial& material, size_t texel);
bool emits(const BakedMaterial& material);  // it has an emission

// Roughness r and strength s of glTF's anisotropy with the lobe of OpenPBR of roughness R and
// anisotropy a; at and ab are the widths along tangent and bitangent: at = mix(ab, 1, s^2) and
// ab = r^2 (KHR_materials_anisotropy), at = R^2 sqrt(2 / (1 + (1 - a)^2)), ab = (1 - a) at
// (OpenPBR 1.1, section "Microfacet model").
struct AnisotropicRoughness {
    float roughness = 0, strength = 0;
};
AnisotropicRoughness host_roughness(const BakedMaterial& material, size_t texel);

// Weight of a coat of index 1.5 with the reflectance of coat_weight at coat_ior, to first order.
float host_coat_weight(const BakedMaterial& material, size_t texel);

// Roughness of Charlie's sheen that resembles OpenPBR's fuzz: fuzz_roughness^1.5, as in three.js's
// MaterialXLoader.
float host_fuzz_roughness(const BakedMaterial& material, size_t texel);

}  // namespace wrinkle
