// Rows of the bake dialog that edit its choices. Their tooltips are the help texts of the
// `wrinkle bake` options (bake/options.h).
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

inline constexpr float bake_wide = 560, bake_padding = 24, picture_side = 160;

// Draws the mesh, the maps, their size and scale; leaves room for a preview image at the right.
void draw_map_rows(State& state);
// Draws the remaining rows; returns true if Enter was pressed in the path field.
bool draw_file_rows(State& state);

}  // namespace wrinkle::editor
