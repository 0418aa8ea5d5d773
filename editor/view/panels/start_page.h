// Start page, shown while there is no graph: drop area for images, buttons, recent files, samples.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns true if there is no file, node or undo step, and no empty graph was requested.
bool is_at_start(const State& state);
void draw_start_page(State& state);

}  // namespace wrinkle::editor
