// Bake dialog: choice of the maps to bake, with a list of the files that the bake writes.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void open_bake_dialog(State& state);

// Returns one sentence on why the current choices cannot be baked now; "" if they can.
std::string why_no_bake(const State& state);
// Returns the files of the bake as a sentence: "Writes normal.png and height.png into strap_maps."
std::string what_is_written(const BakeChoices& choices);

}  // namespace wrinkle::editor
