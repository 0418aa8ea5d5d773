// Environments made by the project itself, as equirectangular images (gpu/environment.h).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "image/image.h"

namespace wrinkle::gpu {

//   studio    Softboxes in a gray room: key, fill, two rims and a top light. A white diffuse
//             surface reflects at most about 1.
//   overcast  A bright sky without lights.
//   contrast  A hard key and rims in a dark room.
//   sun       A clear sky; the Scene's directional light is the sun.
//   furnace   1 everywhere: a surface that neither adds nor loses energy vanishes in it.
enum class Mood : uint8_t { studio, overcast, contrast, sun, furnace };

std::span<const std::string_view> mood_names();  // in the order of the enumerators
std::optional<Mood> mood_named(std::string_view name);

// Returns 512 x 256 texels of linear radiance. Azimuth 0, which the lights refer to, is +z.
Image environment_of(Mood mood);

// Returns the irradiance, over pi, of a surface that faces the mood's directional light; 0 without.
float directional_light_of(Mood mood);

constexpr float key_elevation = 38;  // elevation of the studio's key light, degrees

// Returns the unit vector to the studio's key light when the environment is turned around +y by
// `turn` radians, or to a light at another elevation in radians.
glm::vec3 light_direction(float turn);
glm::vec3 light_direction(float turn, float elevation);

}  // namespace wrinkle::gpu
