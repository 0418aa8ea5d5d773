#include "export/host_values.h"

#include <algorithm>
#include <cmath>

#include "base/standard_outputs.h"

namespace wrinkle {
namespace {

float reflectance_of_ior(float ior) {
    const float ratio = (ior - 1) / (ior + 1);
    return ratio * ratio;
}

// Fraction of the light that reflections inside a coat hold back: of a mirror below it, F0; of a
// diffuse base, 1 - (1 - F) / n^2 with the mean reflectance F (d'Eon, "A Hitchhiker's Guide to
// Multiple Scattering", 2021).
float held_back(float ior, float base_roughness) {
    const float mean = std::log((10893 * ior - 1438.2F) / (-774.4F * ior * ior + 10212 * ior + 1));
    return std::lerp(reflectance_of_ior(ior), 1 - (1 - mean) / (ior * ior), base_roughness);
}

}  // namespace

std::array<float, 3> host_base_color(const BakedMaterial& material, size_t texel) {
    std::array<float, 3> color = material.at("color", texel);
    const auto number = [&](std::string_view name) { return material.at(name, texel)[0]; };
    const float coat = number("coat_weight");
    const auto tint = material.at("coat_color", texel);
    const float roughness = std::lerp(1.0F, number("roughness"), number("metalness"));
    const float held = coat > 0 ? held_back(number("coat_ior"), roughness) : 0;
    for (size_t i = 0; i < 3; ++i) {
        const float albedo = std::clamp(color[i] * number("base_weight"), 0.0F, 1.0F);
        const float darkening = (1 - held) / (1 - albedo * held);
        color[i] = albedo * std::lerp(1.0F, tint[i], coat) *
                   std::lerp(1.0F, darkening, coat * number("coat_darkening"));
    }
    return color;
}

std::initializer_list<std::string_view> base_color_outputs(const BakedMaterial& material) {
    static const std::initializer_list<std::string_view> bare = {"color", "base_weight"};
    static const std::initializer_list<std::string_view> coated = {
        "color",    "base_weight",    "coat_weight", "coat_color",
        "coat_ior", "coat_darkening", "roughness",   "metalness"};
    return material.find("coat_weight") ? coated : bare;
}

bool emits(const BakedMaterial& material) {
    return material.find("emission") || material.find("emission_luminance");
}

std::array<float, 3> host_emission(const BakedMaterial& material, size_t texel) {
    if (!emits(material)) return {};
    std::array<float, 3> radiance = material.at("emission", texel);
    if (material.find("emission_luminance"))
        for (float& channel : radiance)
            channel *= material.at("emission_luminance", texel)[0] /
                       static_cast<float>(nits_of_unit_emission);
    for (float& channel : radiance)
        channel = std::max(channel, 0.0F);
    return radiance;
}

AnisotropicRoughness host_roughness(const BakedMaterial& material, size_t texel) {
    const float roughness = material.at("roughness", texel)[0];
    const float anisotropy = material.at("specular_roughness_anisotropy", texel)[0];
    if (anisotropy == 0) return {roughness, 0};
    const float aspect = 1 - anisotropy;
    const float along =
        std::min(roughness * roughness * std::sqrt(2 / (1 + aspect * aspect)), 1.0F);
    const float across = aspect * along;
    const float strength = across < 1 ? std::sqrt((along - across) / (1 - across)) : 0;
    return {std::sqrt(across), strength};
}

float host_coat_weight(const BakedMaterial& material, size_t texel) {
    const float ior = material.at("coat_ior", texel)[0];
    const float scale = reflectance_of_ior(ior) / reflectance_of_ior(1.5F);
    return std::clamp(material.at("coat_weight", texel)[0] * scale, 0.0F, 1.0F);
}

float host_fuzz_roughness(const BakedMaterial& material, size_t texel) {
    return std::pow(std::max(material.at("fuzz_roughness", texel)[0], 0.0F), 1.5F);
}

}  // namespace wrinkle
