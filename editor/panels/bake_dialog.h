// The dialog in which maps to bake are chosen, and which says what files come of them.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void open_bake_dialog(State& state);
void draw_bake_dialog(State& state);

// Why what is chosen cannot be baked now, one sentence; "" when it can.
std::string why_no_bake(const State& state);
// "Writes normal.png and height.png into strap_maps."
std::string what_is_written(const BakeChoices& choices);

}  // namespace wrinkle::editor
