// Popup for a wire dropped on a pin of another type: the reason, and node types to insert.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void draw_offer(State& state);

}  // namespace wrinkle::editor
