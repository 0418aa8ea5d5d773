// Colors of a color ramp and values of a curve (document/knots.h) from 0 to 1, by the evaluator.
// Values on wires have the defaults of their ports. Empty if the node does not compile.
#pragma once

#include <imgui.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

std::vector<glm::dvec3> ramp_colors(const Node& node, const Registry& registry);  // display colors
std::vector<double> curve_values(const Node& node, const Registry& registry);
// Returns a range that has 0, 1, all values and all points.
Range range_of_curve(const std::vector<double>& values, const std::vector<glm::dvec2>& points);

void draw_ramp_colors(ImDrawList& list, ImVec2 low, ImVec2 high,
                      std::span<const glm::dvec3> colors);
// Draws the values from `range.least` at the lower edge to `range.most` at the upper one.
void draw_curve_values(ImDrawList& list, ImVec2 low, ImVec2 high, std::span<const double> values,
                       const Range& range, ImU32 color);

}  // namespace wrinkle::editor
