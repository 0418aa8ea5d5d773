// Image-based lighting: prefilters an environment map into cube maps, one indexed by roughness.
//
// The image is equirectangular: v 0 is straight down (-y), v 1 straight up, u 0.5 is direction -z
// and u grows towards +x, so that it is not mirrored when seen from inside.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "gpu/gl_handle.h"
#include "image/mips.h"

namespace wrinkle::gpu {

constexpr int environment_levels = 8;
constexpr int environment_side = 256;  // texels of level 0, halved per level
constexpr int irradiance_side = 16;

// Per face of a cube map, side * side RGB texels, in the order and orientation of GL.
using CubeFaces = std::array<std::vector<glm::vec3>, 6>;

struct EnvironmentCube {
    std::array<CubeFaces, environment_levels> reflections;
    CubeFaces irradiance;
};

// Returns the image's first three channels, linear radiance, with mip levels. Negative and
// non-finite values become 0, values above 65504 become 65504.
MipChain radiance_of(const Image& image);

// Level k of the reflections is the radiance gathered by a GGX lobe of roughness (k / 7)^1.5 under
// the assumption N = V = R (Karis, "Real Shading in Unreal Engine 4", 2013): half of the levels are
// below roughness 0.3, where a lobe is narrow, and reflections do not stretch at grazing angles. A
// texel takes up to 256 samples, each from the mip level of the image with texels as large as the
// sample's solid angle (Krivanek and Colbert 2008). The irradiance is the cosine-weighted mean of
// 64 x 32 directions, over pi.
EnvironmentCube prefilter(const Image& image);
double roughness_of_level(int level);

glm::dvec3 cube_direction(int face, glm::dvec2 st);  // unit; s and t in [0, 1] as in GL
glm::dvec2 equirect_uv(glm::dvec3 direction);

class EnvironmentTexture {
public:
    explicit EnvironmentTexture(const EnvironmentCube& cube);
    void bind(int reflections_unit, int irradiance_unit) const;

private:
    TextureHandle reflections_ = TextureHandle::make(), irradiance_ = TextureHandle::make();
};

}  // namespace wrinkle::gpu
