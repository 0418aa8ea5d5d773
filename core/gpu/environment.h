// A picture of the surroundings as light: what a surface reflects of it, by roughness.
//
// The picture is equirectangular: v 0 is straight down (-y), v 1 straight up, u 0.5 looks along -z
// and u grows towards +x, so that from inside it is not mirrored. Its first three channels are
// linear radiance; negative and non-finite values count as 0, larger ones than 65504 as that.
//
// It becomes a cube of six mip levels. Level k of 0 to 4 is what a GGX lobe of roughness k / 4
// gathers when normal, view and reflection coincide (Karis, "Real Shading in Unreal Engine 4",
// 2013); level 5 is the mean weighted by the cosine, the irradiance over pi. 64 or 256 samples a
// texel, each from the picture's mip level whose texels are as large as the sample's share of the
// sphere (Krivanek and Colbert 2008). The error of this is the usual one: reflections do not
// stretch at grazing angles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "image/mips.h"

namespace wrinkle::gpu {

constexpr int environment_levels = 6;
constexpr int environment_side = 128;  // of level 0, halved per level

// faces[level][face]: side * side texels of r, g, b, in the order and orientation of GL's cube
// maps.
struct EnvironmentCube {
    std::array<std::array<std::vector<glm::vec3>, 6>, environment_levels> faces;
};

// The picture's first three channels, every value as above; with its mip levels.
MipChain radiance_of(const Image& picture);

EnvironmentCube prefilter(const Image& picture);

glm::dvec3 cube_direction(int face, glm::dvec2 st);  // unit; s and t in [0, 1] as GL has them
glm::dvec2 equirect_uv(glm::dvec3 direction);

class EnvironmentTexture {
public:
    explicit EnvironmentTexture(const EnvironmentCube& cube);
    EnvironmentTexture(EnvironmentTexture&& other) noexcept;
    EnvironmentTexture& operator=(EnvironmentTexture&& other) noexcept;
    ~EnvironmentTexture();

    void bind(int unit) const;

private:
    uint32_t id_ = 0;
};

}  // namespace wrinkle::gpu
