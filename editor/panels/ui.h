// One frame of the whole window, between ImGui::NewFrame() and ImGui::Render().
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_ui(State& state);

}  // namespace wrinkle::editor
