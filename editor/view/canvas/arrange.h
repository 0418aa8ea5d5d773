// Aligns, distributes and snaps the selected cards. Only positions in the document change.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

enum class Side : uint8_t { left, right, top, bottom, middle_x, middle_y };

Document aligned(const State& state, Side side);
// Equal gaps between the two outermost cards; returns the document unchanged for fewer than three.
Document distributed(const State& state, bool across);
Document snapped(const State& state);  // to the grid of 8

}  // namespace wrinkle::editor
