// From the document to cards and wires on the canvas: sizes, rows and pins in canvas units. Nodes
// without a position are put in columns by their depth; the surface stands left of all nodes and
// the outputs right.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

inline constexpr float detail_zoom = 0.6F;  // below it a card shows no fields
inline constexpr float plain_zoom = 0.35F;  // below it a card is a rectangle
inline constexpr float name_left = 29;      // of a card with a pin in its header
inline constexpr float header_height = 28, row_height = 24, field_height = 21, field_inset = 12;
inline constexpr float cost_height = 20;  // of the last row; 8 without it
inline constexpr float picture_height = 72;
// A pin at either end, the shape in the middle.
inline constexpr float reroute_width = 32, reroute_height = 16;

// Brings state.layout up to the document and to the drag under way. A card is made anew only when
// its node, its type or its readers have changed; a drag moves what it has in its hand.
void update_layout(State& state);

// Where nodes stand by the document, and where those without a place go: in columns by their
// depth, below the cards that have one; `sizes` are those of the cards, by index.
std::vector<ImVec2> places_of(const Document& document, const std::vector<ImVec2>& sizes);
// The same of a document that is not on the canvas, with the size of each card.
std::vector<Extent> places_off_canvas(const State& state, const Document& document);

// Where a pin is, in canvas units.
ImVec2 pin_at(const Card& card, const Pin& pin);

// Canvas units to screen pixels and back.
ImVec2 to_screen(const View& view, ImVec2 at);
ImVec2 to_canvas(const View& view, ImVec2 at);
ImVec2 pointed_at(const View& view);  // the pointer, or the canvas's middle; screen
// All cards in sight, or the selected ones; between what floats over the canvas's upper and lower
// border (panels/overlays.cpp).
void fit(View& view, const Layout& layout, bool selection_only);
// As far out as 5 %, or as shows all cards; as far in as 400 %.
void zoom_at(View& view, const Layout& layout, ImVec2 screen, float factor);
// Moves the view as little as brings the card into it.
void bring_in_sight(View& view, const Card& card);

}  // namespace wrinkle::editor
