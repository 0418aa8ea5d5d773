// The rows of the bake dialog: what is asked for. What the options of `wrinkle bake` say of
// themselves (bake/options.h) is the rows' tooltips.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

inline constexpr float bake_wide = 560, bake_padding = 24, picture_side = 160;

// The mesh, the maps and their size, with room for a picture at the right.
void draw_map_rows(State& state);
// All that is below; true when the place was typed and Enter pressed.
bool draw_file_rows(State& state);

}  // namespace wrinkle::editor
