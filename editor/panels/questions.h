// The dialogs that ask what must be decided first (document/intent.h), and the recent files.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_question(State& state);
void draw_recent_files(State& state);  // rows of the File menu

}  // namespace wrinkle::editor
