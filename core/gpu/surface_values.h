// Values of a material per pixel, as the shaded view stores them between its two passes: the
// material writes them, the lighting reads them (deferred shading). One table gives the text of
// both sides.
//
// A value is a member of the GLSL struct WrView_Surface. Vectors are in world space. Values of
// [0, scale] take 16 bits, unit vectors two times 16 bits in octahedral form (Cigolle et al., "A
// Survey of Efficient Representations for Independent Unit Vectors", JCGT 3(2) 2014), radiance 32
// bits per channel. Eight times 16 bits are one RGBA32UI texel. A pixel of opacity 0 has no
// surface.
#pragma once

#include <string>

#include "emit/emit.h"

namespace wrinkle::gpu {

// The values of a plain material fit into fewer texels; its other values are constants.
enum class SurfaceModel : uint8_t { plain, layered };

// `layered` if the material has an output that a plain pixel does not store, such as a coat's.
SurfaceModel surface_model(const Shader& material);

int surface_texels(SurfaceModel model);  // per pixel; at most 6

// Returns the fragment outputs of the material's pass, `uvec4 WrView_texel0` and following, and
// the functions that pack_surface() calls.
std::string surface_outputs(SurfaceModel model);

// Returns statements of main() that write the texels of a pixel, unless it is invisible or no
// farther than that of the layer before (gpu/surface_buffer.h). Precondition: `surface` is the unit
// surface normal towards the eye in object space, and WrView_m the result of the material.
std::string pack_surface(const Shader& material, SurfaceModel model);

// Returns the struct WrView_Surface and `WrView_Surface WrView_read(ivec2 pixel)`, with samplers
// usampler2D WrView_texel0 and following.
std::string unpack_surface(SurfaceModel model);

// Returns the GLSL expression of an output of WrView_m, converted to the type; "" if the material
// lacks it.
std::string output_expression(const Shader& material, std::string_view output,
                              std::string_view type);

}  // namespace wrinkle::gpu
