// The part of a node's page about the picture that it reads: what it is, the numbers that say so,
// and what is to be said of it, with the button that mends it.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_image_sections(State& state, const Node& node);

// Of the picture at an input, for a tooltip: "Tangent-space normal map, green up: curl +0.87."; ""
// where nothing is known.
std::string image_words(const State& state, const std::string& node, const std::string& port);

}  // namespace wrinkle::editor
