// A small window where a wire was dropped that does not fit: why, and what could stand between.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_offer(State& state);

}  // namespace wrinkle::editor
