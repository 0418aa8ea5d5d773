// From linear radiance to display color: exposure, tone curve, sRGB transfer.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace wrinkle::gpu {

class Program;
struct Scene;

//   neutral  Khronos PBR Neutral (specification of 2024): colors below 0.8 stay, less the 0.04
//            that a dielectric reflects; brighter ones are compressed and desaturated.
//   agx      AgX (Sobotka 2023) with the polynomial of three.js: filmic, desaturates.
//   linear   Clipped to [0, 1].
enum class Tone : uint8_t { neutral, agx, linear };

std::span<const std::string_view> tone_names();  // in the order of the enumerators
std::optional<Tone> tone_named(std::string_view name);

// Returns the GLSL of `vec3 WrView_display(vec3 radiance)` in [0, 1], with its uniforms.
std::string_view display_text();
void set_display_uniforms(const Program& program, const Scene& scene);

// Returns the GLSL of `vec3 WrView_encode(vec3 linear)`, the sRGB transfer of [0, 1].
std::string_view encode_text();

}  // namespace wrinkle::gpu
