// Text on the zoomed canvas. Its letters stand where they stand at zoom 1, times the zoom, so that
// no width and no cut depends on the zoom; the letters themselves are those baked nearest to it.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "editor/look/fonts.h"

namespace wrinkle::editor {

struct TextStyle {
    float size = 16;  // canvas units
    bool bold = false;
    bool right_aligned = false;  // ends at the place it is drawn at
};

inline constexpr float least_text = 6;  // screen pixels; below it a bar stands for the text

// At its upper left corner on the screen.
void draw_magnified(ImDrawList& list, const Fonts& fonts, const TextStyle& style, float zoom,
                    ImVec2 at, ImU32 color, std::string_view text);

// In canvas units.
float magnified_width(const Fonts& fonts, const TextStyle& style, std::string_view text);
// The longest beginning that fits, with "..." when something was cut.
std::string magnified_fitting(const Fonts& fonts, const TextStyle& style, std::string_view text,
                              float width);

}  // namespace wrinkle::editor
