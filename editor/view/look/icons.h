// Icons of 16 x 16 pixels, drawn as strokes.
#pragma once

#include <imgui.h>

#include <string_view>

namespace wrinkle::editor {

// Icons are identified by name: "undo", "add-node", "fit", "check", ... Unknown names draw nothing.
void draw_icon(ImDrawList& list, std::string_view name, ImVec2 center, ImU32 color);
bool has_icon(std::string_view name);

}  // namespace wrinkle::editor
