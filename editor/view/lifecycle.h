// Duties of the window besides drawing: shows another graph, stores the unsaved edits, checks the
// files on disk, reads and writes the settings.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Called once a frame, and occasionally while nothing is drawn: stores the unsaved edits; at most
// once a second, writes the settings and checks the disk. Returns true if the window must be
// redrawn.
bool autosave_and_check_files(State& state);

// Called at the start and before the end of the program.
void use_settings(State& state, const Settings& settings);
void finish(State& state);

}  // namespace wrinkle::editor
