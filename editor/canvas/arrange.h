// Places of the selected cards: in line, evenly apart, on the grid. They change nothing but the
// layout.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

enum class Side : uint8_t { left, right, top, bottom, middle_x, middle_y };

Document aligned(const State& state, Side side);
// With equal gaps between the outermost two.
Document distributed(const State& state, bool across);
Document snapped(const State& state);  // to the grid of 8

}  // namespace wrinkle::editor
