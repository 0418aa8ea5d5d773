// Updates everything derived from the document.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Updates model and layout to the current snapshot, limited to the changes, and requests a build;
// build and preview follow when the worker threads are done.
void refresh(State& state);

// Returns true if build and preview are those of the current snapshot and no job is pending.
bool is_settled(const State& state);

}  // namespace wrinkle::editor
