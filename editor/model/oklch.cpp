#include "editor/model/oklch.h"

#include <cmath>

#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace wrinkle::editor {
namespace {

// By columns.
const glm::dmat3 cones_of_linear{0.4122214708, 0.2119034982, 0.0883024619,   // red
                                 0.5363325363, 0.6806995451, 0.2817188376,   // green
                                 0.0514459929, 0.1073969566, 0.6299787005};  // blue
const glm::dmat3 lab_of_roots{0.2104542553,  1.9779984951,  0.0259040371,
                              0.7936177850,  -2.4285922050, 0.7827717662,
                              -0.0040720468, 0.4505937099,  -0.8086757660};

}  // namespace

glm::dvec3 oklch_of(glm::dvec3 linear) {
    glm::dvec3 roots = cones_of_linear * linear;
    for (int i = 0; i < 3; ++i)
        roots[i] = std::cbrt(roots[i]);
    const glm::dvec3 lab = lab_of_roots * roots;
    const double hue = glm::degrees(std::atan2(lab.z, lab.y));
    return {lab.x, std::hypot(lab.y, lab.z), hue < 0 ? hue + 360 : hue};
}

glm::dvec3 linear_of_oklch(glm::dvec3 lch) {
    const double hue = glm::radians(lch.z);
    const glm::dvec3 lab(lch.x, lch.y * std::cos(hue), lch.y * std::sin(hue));
    const glm::dvec3 roots = glm::inverse(lab_of_roots) * lab;
    return glm::inverse(cones_of_linear) * (roots * roots * roots);
}

}  // namespace wrinkle::editor
