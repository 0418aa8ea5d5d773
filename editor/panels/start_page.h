// What is shown while there is no graph yet: where to drop pictures, buttons, samples.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

// Nothing has a name or a node yet, and nobody has asked for an empty graph.
bool is_at_start(const State& state);
void draw_start_page(State& state);

}  // namespace wrinkle::editor
