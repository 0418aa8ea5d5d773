// Makes room for a card between its neighbours.
#pragma once

#include <string>

#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns the document with the cards that `card` overlaps moved aside: those on its right move
// right with everything downstream, the others move left with everything upstream. If the outputs
// card has to move too, `outputs_at` receives its new position.
Document make_space(const State& state, const Document& document, const Card& card,
                    std::optional<ImVec2>& outputs_at);

// Moves the surface and outputs cards as part of the last committed step; undo moves them back.
void push_borders(State& state, const View::Borders& to);
// Apply the undo or redo of the step that leads to state `serial` to these cards.
void follow_undo(State& state, uint64_t serial);
void follow_redo(State& state, uint64_t serial);

}  // namespace wrinkle::editor
