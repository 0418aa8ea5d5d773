// Builds cards and wires from the document: sizes, rows and pins in canvas units. Nodes without a
// position are placed in columns by their depth; the surface card is left of all nodes and the
// outputs card right of them.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

inline constexpr float detail_zoom = 0.6F;  // below it cards show no fields
inline constexpr float plain_zoom = 0.35F;  // below it cards are plain rectangles
inline constexpr float name_left = 29;      // x of the name, on a card with a header pin
inline constexpr float header_height = 28, row_height = 24, field_height = 21, field_inset = 12;
inline constexpr float cost_height = 20;  // height of the last row; 8 without costs
inline constexpr float node_preview_height = 72;
// A pin at either end, the type's shape in the middle.
inline constexpr float reroute_width = 32, reroute_height = 16;

// Updates state.layout to the document and to the drag in progress. Rebuilds a card only if its
// node, type or readers changed; a drag only moves cards and their wires.
void update_layout(State& state);

// Returns the positions of the nodes, by index: those in the document; nodes without one are placed
// in columns by depth, below the others. `sizes` are the card sizes, by index.
std::vector<ImVec2> places_of(const Document& document, const std::vector<ImVec2>& sizes);
// Same for a document that is not on the canvas; returns the extent of each card.
std::vector<Extent> places_off_canvas(const State& state, const Document& document);

// Returns the selected nodes' cards, in drawing order.
std::vector<const Card*> selected_cards(const State& state);
// Returns the pin of a port; nullptr if the card has none.
const Pin* find_pin(const Card& card, std::string_view port, bool output);
// Returns the position of a pin, in canvas units.
ImVec2 pin_at(const Card& card, const Pin& pin);

// Canvas units to screen pixels and back.
ImVec2 to_screen(const View& view, ImVec2 at);
ImVec2 to_canvas(const View& view, ImVec2 at);
ImVec2 pointed_at(const View& view);  // the pointer, else the canvas's center; screen pixels
// Fits all cards, or the selected ones, between the overlays at the upper and lower border of the
// canvas (panels/overlays.cpp).
void fit(View& view, const Layout& layout, bool selection_only);
// Zooms with `screen` fixed, between 400 % and 5 %, or less if all cards need it.
void zoom_at(View& view, const Layout& layout, ImVec2 screen, float factor);
// Returns the minimap's rectangle, in the lower right corner; empty where the canvas is too small.
// Screen pixels.
Extent minimap_area(const View& view);
// Returns true if the card is on the canvas completely; the minimap does not count.
bool is_in_sight(const View& view, const Card& card);
// Pans by the smallest amount that shows the card, and not below the minimap if there is room.
void bring_in_sight(View& view, const Card& card);

}  // namespace wrinkle::editor
