// The text of a note or the title of a frame, edited where it stands.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_box_text(State& state);

}  // namespace wrinkle::editor
