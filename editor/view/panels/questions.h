// Modal prompts for pending decisions (document/intent.h), and the list of recent files.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void draw_question(State& state);
void draw_recent_files(State& state);  // rows of the File menu

}  // namespace wrinkle::editor
