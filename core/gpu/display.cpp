#include "gpu/display.h"

#include <algorithm>
#include <array>
#include <string>

#include "gpu/program.h"
#include "gpu/renderer.h"

namespace wrinkle::gpu {
namespace {

constexpr std::array<std::string_view, 3> tones{"neutral", "agx", "linear"};

constexpr std::string_view transfer = R"(
vec3 WrView_encode(vec3 linear) {
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
)";

constexpr std::string_view curves = R"(
uniform float WrView_exposure;
uniform int WrView_tone;

vec3 WrView_neutral(vec3 c) {
    const float start = 0.8 - 0.04, desaturation = 0.15;
    float low = min(c.r, min(c.g, c.b));
    c -= low < 0.08 ? low - 6.25 * low * low : 0.04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak < start) return c;
    float room = 1.0 - start;
    float new_peak = 1.0 - room * room / (peak + room - start);
    float saturation = 1.0 / (desaturation * (peak - new_peak) + 1.0);
    return mix(vec3(new_peak), c * new_peak / peak, saturation);
}

vec3 WrView_agx(vec3 c) {
    const mat3 to_rec2020 = mat3(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0113,
                                 0.8956);
    const mat3 from_rec2020 = mat3(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728,
                                   -0.0083, 1.1187);
    const mat3 inset = mat3(0.8566271533, 0.1373189729, 0.1118982130, 0.0951212405, 0.7612419906,
                            0.0767994186, 0.0482516061, 0.1014390365, 0.8113023684);
    const mat3 outset = mat3(1.1271005818, -0.1413297635, -0.1413297635, -0.1106066431,
                             1.1578237022, -0.1106066431, -0.0164939387, -0.0164939387,
                             1.2519364066);
    const float low_ev = -12.47393, high_ev = 4.026069;
    vec3 x = log2(max(inset * (to_rec2020 * c), 1e-10));
    x = clamp((x - low_ev) / (high_ev - low_ev), 0.0, 1.0);
    vec3 x2 = x * x, x4 = x2 * x2;
    x = 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x
        - 0.00232;
    return from_rec2020 * pow(max(outset * x, 0.0), vec3(2.2));
}

vec3 WrView_display(vec3 radiance) {
    vec3 c = max(radiance * WrView_exposure, 0.0);
    if (WrView_tone == 0) c = WrView_neutral(c);
    if (WrView_tone == 1) c = WrView_agx(c);
    return WrView_encode(c);
}
)";

}  // namespace

std::span<const std::string_view> tone_names() {
    return tones;
}

std::optional<Tone> tone_named(std::string_view name) {
    const auto* found = std::ranges::find(tones, name);
    if (found == tones.end()) return std::nullopt;
    return static_cast<Tone>(found - tones.begin());
}

std::string_view encode_text() {
    return transfer;
}

std::string_view display_text() {
    static const std::string text = std::string(transfer).append(curves);
    return text;
}

void set_display_uniforms(const Program& program, const Scene& scene) {
    program.set("WrView_exposure", scene.exposure);
    program.set("WrView_tone", static_cast<int>(scene.tone));
}

}  // namespace wrinkle::gpu
