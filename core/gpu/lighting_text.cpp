#include "gpu/lighting_text.h"

#include <string>

namespace wrinkle::gpu {
namespace {

// Light that arrives at a surface: one directional light and an environment. WrView_light is
// irradiance over pi, so that a white diffuse surface that faces the light reflects WrView_light.
constexpr std::string_view light_text = R"(
uniform vec3 WrView_to_light;
uniform float WrView_light;
uniform samplerCube WrView_reflections;
uniform samplerCube WrView_irradiances;
uniform vec2 WrView_environment_turn;  // cosine and sine
uniform float WrView_environment;

vec3 WrView_turned(vec3 d) {
    float c = WrView_environment_turn.x, s = WrView_environment_turn.y;
    return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

vec3 WrView_irradiance(vec3 n) {
    return textureLod(WrView_irradiances, WrView_turned(n), 0.0).rgb * WrView_environment;
}

// Level k of the map has roughness (k / 7)^1.5. A bumped reflection that points into the surface
// fades.
vec3 WrView_reflected(vec3 direction, float roughness, vec3 surface) {
    float above = min(1.0, 1.0 + dot(direction, surface));
    float level = 7.0 * pow(roughness, 2.0 / 3.0);
    return textureLod(WrView_reflections, WrView_turned(direction), level).rgb
           * (WrView_environment * above * above);
}
)";

constexpr std::string_view lobes_text = R"(
uniform sampler2D WrView_albedos;  // gpu/albedo.h

vec4 WrView_albedo(float nv, float roughness) {
    vec2 at = vec2(sqrt(nv), roughness) * 31.0 + 0.5;
    return texture(WrView_albedos, at / 32.0);
}

// A unit vector at right angles to n.
vec3 WrView_across(vec3 n) {
    return normalize(cross(n, abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
}

// GGX with height-correlated Smith masking, times pi, without Fresnel's term. `alpha` is along t
// and b.
float WrView_ggx(vec3 n, vec3 t, vec3 b, vec3 v, vec3 l, vec2 alpha) {
    alpha = max(alpha, 0.002);
    vec3 h = normalize(v + l);
    float nv = max(dot(n, v), 1e-3), nl = max(dot(n, l), 1e-3);
    vec3 slope = vec3(dot(h, t) / alpha.x, dot(h, b) / alpha.y, dot(h, n));
    float facet = dot(slope, slope);
    float towards = nl * length(vec3(alpha.x * dot(v, t), alpha.y * dot(v, b), nv));
    float away = nv * length(vec3(alpha.x * dot(l, t), alpha.y * dot(l, b), nl));
    return 0.5 / (alpha.x * alpha.y * facet * facet * (towards + away));
}

float WrView_fresnel(float cosine) {
    float x = 1.0 - clamp(cosine, 0.0, 1.0), x2 = x * x;
    return x2 * x2 * x;
}

float WrView_f0(float ior) {
    float r = (ior - 1.0) / (ior + 1.0);
    return r * r;
}

// EON: albedo of the single scattering of a white surface, and color of the multiple one.
float WrView_eon_albedo(float cosine, float roughness) {
    float x = 1.0 - cosine;
    float g = x * (0.0571085289 + x * (0.491881867 + x * (-0.332181442 + x * 0.0714429953)));
    return (1.0 + roughness * g) / (1.0 + 0.287793 * roughness);
}

vec3 WrView_eon_multiple(vec3 rho, float roughness) {
    float mean = (1.0 + 0.0724882 * roughness) / (1.0 + 0.287793 * roughness);
    return rho * rho * mean / (1.0 - rho * (1.0 - mean));
}

vec3 WrView_eon(vec3 rho, float roughness, vec3 n, vec3 v, vec3 l) {
    float nv = max(dot(n, v), 1e-3), nl = max(dot(n, l), 1e-3);
    float s = dot(l, v) - nl * nv;
    float bend = s > 0.0 ? s / max(nl, nv) : s;
    float single = (1.0 + roughness * bend) / (1.0 + 0.287793 * roughness);
    float mean = (1.0 + 0.0724882 * roughness) / (1.0 + 0.287793 * roughness);
    float lost = (1.0 - WrView_eon_albedo(nv, roughness)) * (1.0 - WrView_eon_albedo(nl, roughness))
                 / max(1.0 - mean, 1e-7);
    return rho * single + WrView_eon_multiple(rho, roughness) * lost;
}

// Index of refraction with specular_weight applied to its reflectance; below a coat, relative to
// the coat's and never below 1, so that there is no total reflection.
float WrView_base_f0(WrView_Surface s) {
    float ior = mix(s.ior, s.ior / s.coat_ior, s.coat_weight);
    return min(WrView_f0(max(ior, 1.0 / max(ior, 1e-3))) * s.specular_weight, 1.0);
}

float WrView_base_roughness(WrView_Surface s) {
    float rough = pow(min(1.0, pow(s.roughness, 4.0) + 2.0 * pow(s.coat_roughness, 4.0)), 0.25);
    return mix(s.roughness, rough, s.coat_weight);
}

// Fraction of the light that reflections inside of the coat hold back.
float WrView_held_back(WrView_Surface s, float base_roughness) {
    float n = s.coat_ior;
    float mean = log((10893.0 * n - 1438.2) / (-774.4 * n * n + 10212.0 * n + 1.0));
    return mix(WrView_f0(n), 1.0 - (1.0 - mean) / (n * n), base_roughness);
}
)";

constexpr std::string_view ggx_lit_text = R"(
// Radiance below the coat, and the albedo there.
vec3 WrView_base(WrView_Surface s, vec3 v, out vec3 albedo) {
    vec3 n = s.normal, l = WrView_to_light;
    float nv = clamp(dot(n, v), 1e-3, 1.0), nl = max(dot(n, l), 0.0) * WrView_light;
    float roughness = WrView_base_roughness(s);
    vec3 color = s.color * s.base_weight;
    vec3 t = s.tangent - n * dot(n, s.tangent);
    t = dot(t, t) > 1e-8 ? normalize(t) : WrView_across(n);
    vec3 b = cross(n, t);
    float narrow = 1.0 - s.anisotropy;
    float alpha_t = roughness * roughness * sqrt(2.0 / (1.0 + narrow * narrow));
    float lobe = nl > 0.0 ? WrView_ggx(n, t, b, v, l, vec2(alpha_t, narrow * alpha_t)) : 0.0;
    float vh = dot(v, normalize(v + l));

    vec4 e = WrView_albedo(nv, roughness);
    float lost = (1.0 - e.x - e.y) / max(e.x + e.y, 1e-3);
    float f0 = WrView_base_f0(s), f90 = min(1.0, 50.0 * f0), edge = WrView_fresnel(vh);
    float specular_gain = 1.0 + f0 * lost;
    float specular = (f0 * e.x + f90 * e.y) * specular_gain;
    vec3 metal_gain = (1.0 + color * lost) * min(s.specular_weight, 1.0);
    vec3 dark = (color + (1.0 - color) * 0.4627) * (1.0 - s.specular_color) * 17.6514;
    vec3 metal = (color * e.x + e.y - dark * e.z) * metal_gain;

    // Stretched along the tangent by a normal that is bent against it.
    vec3 bent = cross(cross(b, v), b);
    float bend = s.anisotropy * (1.0 - roughness);
    vec3 axis = normalize(mix(n, normalize(bent + n * 1e-4), 1.0 - pow(1.0 - bend, 4.0)));
    float open = pow(nv + s.occlusion, exp2(-16.0 * roughness - 1.0)) - 1.0 + s.occlusion;
    vec3 around = WrView_reflected(reflect(-v, axis), roughness, s.surface) * clamp(open, 0.0, 1.0);

    vec3 rho = mix(color, s.subsurface_color, s.subsurface_weight);
    vec3 sky = WrView_diffuse_light(s, n);
    vec3 diffuse = rho * WrView_eon_albedo(nv, s.diffuse_roughness)
                   + WrView_eon_multiple(rho, s.diffuse_roughness)
                         * (1.0 - WrView_eon_albedo(nv, s.diffuse_roughness));
    float below = 1.0 - min(specular, 1.0);
    vec3 dielectric = s.specular_color * specular * around + below * diffuse * sky * s.occlusion;
    vec3 conductor = metal * around;
    if (nl > 0.0) {
        vec3 mirror = color + (1.0 - color) * edge - dark * vh * pow(1.0 - vh, 6.0);
        dielectric += (s.specular_color * lobe * mix(f0, f90, edge) * specular_gain
                       + below * WrView_eon(rho, s.diffuse_roughness, n, v, l)) * nl;
        conductor += mirror * metal_gain * lobe * nl;
    }
    albedo = mix(s.specular_color * specular + below * diffuse, metal, s.metalness);
    return mix(dielectric, conductor, s.metalness);
}

vec3 WrView_lit(WrView_Surface s, vec3 v) {
    vec3 albedo;
    vec3 base = WrView_base(s, v, albedo);
    return WrView_layers_over(s, v, base, albedo);
}
)";

// A plain surface has no coat, no fuzz and nothing below it.
constexpr std::string_view plain_text = R"(
vec3 WrView_diffuse_light(WrView_Surface s, vec3 n) {
    return WrView_irradiance(n);
}

vec3 WrView_layers_over(WrView_Surface s, vec3 v, vec3 base, vec3 albedo) {
    return base + s.emission;
}
)";

constexpr std::string_view layered_text = R"(
// Light that scatters below the surface blurs its bumps, red most.
vec3 WrView_diffuse_light(WrView_Surface s, vec3 n) {
    vec3 flat_part = 0.8 * s.subsurface_weight * s.subsurface_scale;
    vec3 red = normalize(mix(n, s.surface, flat_part.r));
    vec3 green = normalize(mix(n, s.surface, flat_part.g));
    vec3 blue = normalize(mix(n, s.surface, flat_part.b));
    return vec3(WrView_irradiance(red).r, WrView_irradiance(green).g, WrView_irradiance(blue).b);
}

vec3 WrView_layers_over(WrView_Surface s, vec3 v, vec3 base, vec3 albedo) {
    vec3 n = s.coat_normal, l = WrView_to_light;
    float nv = clamp(dot(n, v), 1e-3, 1.0), nl = max(dot(n, l), 0.0) * WrView_light;
    float f0 = WrView_f0(s.coat_ior), f90 = min(1.0, 50.0 * f0);
    vec4 e = WrView_albedo(nv, s.coat_roughness);
    float gain = 1.0 + f0 * (1.0 - e.x - e.y) / max(e.x + e.y, 1e-3);
    float reflected = min((f0 * e.x + f90 * e.y) * gain, 1.0);
    vec3 coat = reflected * WrView_reflected(reflect(-v, n), s.coat_roughness, s.surface)
                * mix(1.0, s.occlusion, s.coat_roughness);
    vec3 t = WrView_across(n);
    if (nl > 0.0) {
        float edge = WrView_fresnel(dot(v, normalize(v + l)));
        float alpha = s.coat_roughness * s.coat_roughness;
        coat += mix(f0, f90, edge) * gain * nl * WrView_ggx(n, t, cross(n, t), v, l, vec2(alpha));
    }
    float inside = sqrt(max(1.0 - (1.0 - nv * nv) / (s.coat_ior * s.coat_ior), 1e-4));
    vec3 passed = pow(s.coat_color, vec3(1.0 / inside)) * (1.0 - reflected);
    passed = mix(vec3(1.0), passed, s.coat_weight);
    float held = WrView_held_back(s, mix(1.0, WrView_base_roughness(s), s.metalness));
    vec3 darkening = mix(vec3(1.0), (1.0 - held) / (1.0 - min(albedo, 1.0) * held),
                         s.coat_weight * s.coat_darkening);
    vec3 coated = s.coat_weight * coat + passed * (base * darkening + s.emission);

    vec3 nf = normalize(mix(s.normal, n, s.coat_weight));
    float fuzz = WrView_albedo(clamp(dot(nf, v), 1e-3, 1.0), s.fuzz_roughness).w * s.fuzz_weight;
    vec3 lit = WrView_irradiance(nf) * s.occlusion + max(dot(nf, l), 0.0) * WrView_light;
    return fuzz * s.fuzz_color * lit + (1.0 - fuzz) * coated;
}
)";

constexpr std::string_view phong_lit_text = R"(
uniform vec3 WrView_to_light;
uniform vec4 WrView_phong;  // Ka, Kd, Ks, shininess

vec3 WrView_lit(WrView_Surface s, vec3 v) {
    float nl = max(dot(s.normal, WrView_to_light), 0.0);
    float rv = max(dot(reflect(-WrView_to_light, s.normal), v), 0.0);
    float highlight = nl > 0.0 && rv > 0.0 ? pow(rv, WrView_phong.w) : 0.0;
    return s.color * (WrView_phong.x + WrView_phong.y * nl) + WrView_phong.z * highlight
           + s.emission;
}
)";

}  // namespace

std::string ggx_text(SurfaceModel model) {
    return std::string(light_text)
        .append(lobes_text)
        .append(model == SurfaceModel::plain ? plain_text : layered_text)
        .append(ggx_lit_text);
}

std::string_view phong_text() {
    return phong_lit_text;
}

}  // namespace wrinkle::gpu
