// From the document to cards and wires on the canvas: sizes, rows and pins in canvas units. Nodes
// without a position are put in columns by their depth; the surface stands left of all nodes and
// the outputs right.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

inline constexpr float detail_zoom = 0.6F;  // below it a card shows no fields
inline constexpr float plain_zoom = 0.35F;  // below it a card is a rectangle
inline constexpr float header_height = 28, row_height = 24, field_height = 21, field_inset = 12;
// A pin at either end, the shape in the middle.
inline constexpr float reroute_width = 32, reroute_height = 16;

// Brings state.layout up to the document and to the drag under way. A card is made anew only when
// its node, its type or its readers have changed; a drag moves what it has in its hand.
void update_layout(State& state);

// Where nodes stand by the document, and where those without a place go; whether there are none.
std::vector<ImVec2> places_of(const Document& document, bool* all_given = nullptr);

// Where a pin is, in canvas units.
ImVec2 pin_at(const Card& card, const Pin& pin);

// Every node in the column of its depth, below the one before it, with room between them.
Document tidied(const State& state);

// A place where a new card of about that size covers nobody, near `at`; on the grid.
ImVec2 free_place(const Layout& layout, ImVec2 at);

// Canvas units to screen pixels and back.
ImVec2 to_screen(const View& view, ImVec2 at);
ImVec2 to_canvas(const View& view, ImVec2 at);
ImVec2 pointed_at(const View& view);  // the pointer, or the canvas's middle; screen
void fit(View& view, const Layout& layout, bool selection_only);
void zoom_at(View& view, ImVec2 screen, float factor);

}  // namespace wrinkle::editor
