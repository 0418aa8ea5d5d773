// Icons of 16 pixels, as strokes.
#pragma once

#include <imgui.h>

#include <string_view>

namespace wrinkle::editor {

// By the name of what it stands for: "undo", "add-node", "fit", "check", ... Nothing for a name
// that has none.
void draw_icon(ImDrawList& list, std::string_view name, ImVec2 center, ImU32 color);
bool has_icon(std::string_view name);

}  // namespace wrinkle::editor
