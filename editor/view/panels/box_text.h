// In-place editor for the text of a note or the title of a frame.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void draw_box_text(State& state);

}  // namespace wrinkle::editor
