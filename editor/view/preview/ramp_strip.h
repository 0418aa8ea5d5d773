// Colors of a color ramp (document/ramp.h) from 0 to 1, by the CPU evaluator.
#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

// Returns display colors from left to right; values on wires have the defaults of their ports.
// Empty if the node does not compile.
std::vector<glm::dvec3> ramp_strip(const Node& node, const Registry& registry);

void draw_strip(ImDrawList& list, ImVec2 low, ImVec2 high, std::span<const glm::dvec3> colors);

}  // namespace wrinkle::editor
