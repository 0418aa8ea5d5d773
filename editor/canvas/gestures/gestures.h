// What the hand does on the canvas, one file each. A gesture begins with a press, follows the
// pointer and ends with the release; Escape takes back what it did. The document changes in one
// step of history.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void begin_gesture(State& state, Gesture::Kind kind);

// select.cpp
void select_card(State& state, const std::string& id);
void drag_box(State& state);

// move.cpp
void drag_move(State& state, ImVec2 delta);
void drop_cards(State& state);

// wire.cpp
void begin_wire(State& state, const Card& card, const Pin& pin);
void lift_wire(State& state);
void drop_wire(State& state);

// value.cpp
void open_popup(State& state, const Card& card, const Field* field, Popup::Kind kind);
void begin_value(State& state, const Card& card, const Field& field);
void drag_value(State& state, ImVec2 delta);
void drop_value(State& state);

}  // namespace wrinkle::editor
