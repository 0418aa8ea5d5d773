// Sections of a node's help page on the images that it reads: the facts found with the measured
// values, and the remarks with buttons for their remedies.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void draw_image_sections(State& state, const Node& node);

// Returns a tooltip on the image at an input: "Tangent-space normal map, green up: curl +0.87.", or
// why it could not be examined; "" if it was not examined.
std::string image_words(const State& state, const std::string& node, const std::string& port);

}  // namespace wrinkle::editor
