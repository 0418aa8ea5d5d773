// Room for a card between its neighbours.
#pragma once

#include <string>

#include "editor/state.h"

namespace wrinkle::editor {

// The document with the cards moved aside that `card` lies over, those on its right with all that
// is made of them to the right, the others with all that they are made of to the left. Where the
// card of the graph's outputs is one of them, `outputs_at` says where it stands then.
Document with_room(const State& state, const Document& document, const Card& card,
                   std::optional<ImVec2>& outputs_at);

// The cards at the borders move with the step that was committed last, and back with undo.
void push_borders(State& state, const View::Borders& to);
// What undo and redo of the step that leads to the state `serial` do to it.
void follow_undo(State& state, uint64_t serial);
void follow_redo(State& state, uint64_t serial);

}  // namespace wrinkle::editor
