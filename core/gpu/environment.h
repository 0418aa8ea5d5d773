// Image-based lighting: prefilters an environment map into a cube map indexed by roughness.
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

constexpr int environment_levels = 6;
constexpr int environment_side = 128;  // texels of level 0, halved per level

// faces[level][face]: side * side RGB texels, in the order and orientation of GL's cube maps.
struct EnvironmentCube {
    std::array<std::array<std::vector<glm::vec3>, 6>, environment_levels> faces;
};

// Returns the image's first three channels, linear radiance, with mip levels. Negative and
// non-finite values become 0, values above 65504 become 65504.
MipChain radiance_of(const Image& image);

// The cube map has six mip levels. Level k of 0 to 4 is the radiance gathered by a GGX lobe of
// roughness k / 4 under the assumption N = V = R (Karis, "Real Shading in Unreal Engine 4", 2013);
// level 5 is the cosine-weighted mean, the irradiance over pi. Each texel of levels 1 to 5 takes 64
// (level 1) or 256 samples, each from the mip level of the image with texels as large as the
// sample's solid angle (Krivanek and Colbert 2008). Because of N = V = R, reflections do not
// stretch at grazing angles.
EnvironmentCube prefilter(const Image& image);

glm::dvec3 cube_direction(int face, glm::dvec2 st);  // unit; s and t in [0, 1] as in GL
glm::dvec2 equirect_uv(glm::dvec3 direction);

class EnvironmentTexture {
public:
    explicit EnvironmentTexture(const EnvironmentCube& cube);
    void bind(int unit) const;

private:
    TextureHandle handle_ = TextureHandle::make();
};

}  // namespace wrinkle::gpu
