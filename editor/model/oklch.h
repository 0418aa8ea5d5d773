// Colors by lightness, chroma and hue: OKLCh, the polar form of OKLab (B. Ottosson, "A perceptual
// color space for image processing", 2020). Colors are linear Rec. 709.
#pragma once

#include <glm/vec3.hpp>

namespace wrinkle::editor {

// Returns lightness (0 black, 1 white), chroma (0 grey) and hue (degrees, 0 to 360).
glm::dvec3 oklch_of(glm::dvec3 linear);

// The inverse. A color outside of the gamut has a component below 0 or above 1.
glm::dvec3 linear_of_oklch(glm::dvec3 lch);

}  // namespace wrinkle::editor
