// What a material needs that not every machine of its target has.
#pragma once

#include <string>

#include "glsl/reflection.h"

namespace wrinkle {

// Units for images that each target gives a fragment shader at least: GL_MAX_TEXTURE_IMAGE_UNITS of
// OpenGL 3.3 and ES 3.0, maxPerStageDescriptorSampledImages of Vulkan, sampler states of shader
// model 5.0 and of Metal.
inline constexpr size_t guaranteed_texture_units = 16;

// One sentence that names what is too much, with its remedy; "" when nothing is.
struct Excess {
    std::string problem, remedy;
};
Excess texture_unit_excess(const Reflection& reflection);
Excess draw_buffer_excess(const Reflection& reflection);  // of the shader form

}  // namespace wrinkle
