// What the hand does on the canvas, one file each. A gesture begins with a press, follows the
// pointer and ends with the release; Escape takes back what it did. The document changes in one
// step of history.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void begin_gesture(State& state, Gesture::Kind kind, int button = 0);

// select.cpp
void select_card(State& state, const std::string& id);
void click_card(State& state, const std::string& id);  // a press that moved nothing
void drag_box(State& state);
void drag_lasso(State& state);

// boxes.cpp
void select_box(State& state, const BoxId& id);
void begin_box(State& state, const Hit& hit);  // moved by its title, resized at its edges
void click_box(State& state, const BoxId& id);
void drag_resize(State& state, ImVec2 delta);

// edge_pan.cpp
void pan_at_edges(State& state);

// move.cpp
void begin_move(State& state, const std::string& id);
void carry_selection(State& state);  // and what stands in the selected frames
void drag_move(State& state, ImVec2 delta);
void drop_cards(State& state);

// wire.cpp
// The pin that a wire would end at: the nearest one that it fits within 12 pixels, else the row of
// a card, else the card's own choice; a pin that it does not fit where there is nothing better.
Hit aim_wire(const State& state, ImVec2 mouse);
void begin_wire(State& state, const Card& card, const Pin& pin);
void lift_wire(State& state);
void drop_wire(State& state);

// value.cpp
void open_popup(State& state, const Card& card, const Field* field, Popup::Kind kind);
void begin_value(State& state, const Card& card, const Field& field);
void drag_value(State& state, ImVec2 delta);
void drop_value(State& state);

// stroke.cpp
// Where the pointer is now becomes the end of the stroke; false where it has not moved on.
bool follow_stroke(State& state);
void drag_stroke(State& state);
void drop_cut(State& state);
void drop_reroutes(State& state);
// A reroute in the wire, where it was hit; canvas units.
void reroute_wire(State& state, size_t wire, ImVec2 at);

// lazy.cpp
void drop_lazy(State& state);

}  // namespace wrinkle::editor
