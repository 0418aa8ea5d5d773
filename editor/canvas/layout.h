// From the document to cards and wires on the canvas: sizes, rows and pins in canvas units. Nodes
// without a position are put in columns by their depth; the surface stands left of all nodes and
// the outputs right.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

inline constexpr float detail_zoom = 0.5F;  // below it a card shows no rows
inline constexpr float header_height = 28, row_height = 24, field_height = 21, field_inset = 12;

Layout lay_out(const State& state);

// Where a pin is, in canvas units.
ImVec2 pin_at(const Card& card, const Pin& pin);

// Every node in the column of its depth, below the one before it, with room between them.
Document tidied(const State& state);

// A place where a new card of about that size covers nobody, near `at`; on the grid.
ImVec2 free_place(const Layout& layout, ImVec2 at);

// Canvas units to screen pixels and back.
ImVec2 to_screen(const View& view, ImVec2 at);
ImVec2 to_canvas(const View& view, ImVec2 at);
void fit(View& view, const Layout& layout, bool selection_only);
void zoom_at(View& view, ImVec2 screen, float factor);

}  // namespace wrinkle::editor
