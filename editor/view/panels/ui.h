// Draws one frame of the window; call between ImGui::NewFrame() and ImGui::Render().
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void draw_ui(State& state);

}  // namespace wrinkle::editor
