// What follows from the document, brought up to it.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

// Brings model and layout up to the present snapshot, doing no more than changed, and asks for the
// texts; those and the picture follow when the compiler has them.
void refresh(State& state);

// Whether nothing is on its way any more: texts and picture are of the present snapshot.
bool is_settled(const State& state);

}  // namespace wrinkle::editor
