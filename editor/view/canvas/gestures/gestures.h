// Pointer gestures on the canvas, one file each. A gesture begins with a press, follows the pointer
// and ends with the release; Escape reverts it. The document changes in one history step.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void begin_gesture(State& state, Gesture::Kind kind, int button = 0);

// select.cpp
void select_card(CanvasState& canvas, const std::string& id);
void select_box(CanvasState& canvas, const BoxId& id);
void click_card(CanvasState& canvas, const std::string& id);  // a press without a drag
void click_box(CanvasState& canvas, const BoxId& id);
void drag_box(State& state, ImVec2 delta);
void drag_lasso(State& state, ImVec2 delta);

// move.cpp
void begin_box(State& state, const Hit& hit);  // moves it by its title, resizes it at its edges
void drag_resize(State& state, ImVec2 delta);
void begin_move(State& state, const std::string& id);
void carry_selection(State& state);  // and the contents of the selected frames
void drag_move(State& state, ImVec2 delta);
void drop_cards(State& state);  // selects the pressed card or box if nothing moved

// wire.cpp
// Returns the target pin of a wire: the nearest fitting pin within 12 pixels, else the pin of the
// hovered row, else the best-fitting pin of the card. A pin that does not fit is returned only if
// there is no better one.
Hit snap_wire(const State& state, ImVec2 mouse);
void begin_wire(State& state, const Card& card, const Pin& pin);
void lift_wire(State& state);  // at the first motion: detaches a wire that began at its input
void drop_wire(State& state);

// The wire of a drag between two cards: forward, else backward to a free input. Its pins fit best:
// equal types before convertible ones, free inputs before connected ones, then equal names, then
// pin order.
struct LazyWire {
    const Card *from = nullptr, *to = nullptr;
    const Pin *out = nullptr, *in = nullptr;
};
std::optional<LazyWire> lazy_wire(const State& state, const Card& first, const Card& last);
void drop_lazy(State& state);

// value.cpp
void open_popup(State& state, const Card& card, const Field* field, Popup::Kind kind);
void begin_value(State& state, const Card& card, const Field& field);
void drag_value(State& state, ImVec2 delta);
void drop_value(State& state);

// stroke.cpp
// Appends the pointer position to the stroke; returns false if the pointer has not moved.
bool follow_stroke(CanvasState& canvas);
void drag_stroke(State& state, ImVec2 delta);
void drop_cut(State& state);
void drop_reroutes(State& state);
// Inserts a reroute into the wire at `at`, in canvas units.
void reroute_wire(State& state, size_t wire, ImVec2 at);

}  // namespace wrinkle::editor
