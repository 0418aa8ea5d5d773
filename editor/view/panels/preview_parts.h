// Parts of the preview panel.
#pragma once

#include "editor/view/panels/panels.h"

namespace wrinkle::editor {

void draw_preview_image(State& state, ImVec2 at, ImVec2 size);
void draw_flat(State& state, ImVec2 at, ImVec2 size);  // the 2D view
void use_flat_handles(State& state, const FlatPanel& panel);
float compare_height(float width);
void draw_compare(State& state, ImVec2 at, float width);

// Returns the label of the method or value on side B of the comparison: "UDN blend".
std::string against_label(const PreviewRequest& request);

std::string mesh_label(const std::string& mesh);  // "Sphere", "teapot.glb"

std::string capitalised(std::string text);  // ASCII

// Draws small text on a background that is readable over any image. `at` is the upper left corner,
// the upper right one if `right_aligned`; color 0 is theme::text. Returns the width in pixels.
float draw_chip(const Fonts& fonts, ImVec2 at, const std::string& text, bool right_aligned = false,
                ImU32 color = 0);

}  // namespace wrinkle::editor
