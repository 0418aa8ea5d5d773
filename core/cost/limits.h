// Checks of a material against the resource limits that its target guarantees.
#pragma once

#include <string>

#include "emit/reflection.h"

namespace wrinkle {

// Minimum number of texture units of a fragment shader on each target:
// GL_MAX_TEXTURE_IMAGE_UNITS of OpenGL 3.3 and ES 3.0, maxPerStageDescriptorSampledImages of
// Vulkan, sampler states of shader model 5.0 and of Metal.
inline constexpr size_t guaranteed_texture_units = 16;

// One sentence that names the excess resources, and a hint; both "" if no limit is exceeded.
struct Excess {
    std::string problem, remedy;
};
Excess texture_unit_excess(const Reflection& reflection);
Excess draw_buffer_excess(const Reflection& reflection);  // shader form only

}  // namespace wrinkle
