// Bake dialog: choice of the maps to bake, with a list of the files that the bake writes.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void open_bake_dialog(State& state);

// Returns one sentence on why the current choices cannot be baked now; "" if they can.
std::string why_no_bake(const State& state);
// Returns the files of the bake as a sentence: "Writes normal.png and height.png into strap_maps."
std::string what_is_written(const BakeChoices& choices);

// Rows of the dialog that edit its choices. Their tooltips are the help texts of the `wrinkle bake`
// options (bake/options.h).
inline constexpr float bake_wide = 560, bake_padding = 24, preview_side = 160;

// Draws the mesh, the maps, their size and scale; leaves room for a preview image at the right.
void draw_map_rows(State& state);
// Draws the remaining rows; returns true if Enter was pressed in the path field.
bool draw_file_rows(State& state);

}  // namespace wrinkle::editor
