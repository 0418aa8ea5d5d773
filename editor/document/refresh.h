// What follows from the document, brought up to it.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

// Brings model, build, layout and preview up to the present snapshot, doing no more than changed.
void refresh(State& state);

}  // namespace wrinkle::editor
