// Text on the zoomed canvas. Glyph positions are those at zoom 1, times the zoom, so that text
// width and truncation do not depend on the zoom; the glyphs come from the nearest baked size.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "editor/view/look/fonts.h"

namespace wrinkle::editor {

struct TextStyle {
    float size = 16;  // canvas units
    bool bold = false;
    bool right_aligned = false;  // ends at the given position
};

inline constexpr float min_text = 6;  // screen pixels; smaller text is drawn as a bar

// `at` is the upper left corner, or the upper right one if right-aligned; screen pixels.
void draw_magnified(ImDrawList& list, const Fonts& fonts, const TextStyle& style, float zoom,
                    ImVec2 at, ImU32 color, std::string_view text);

// Text width in canvas units.
float magnified_width(const Fonts& fonts, const TextStyle& style, std::string_view text);
// The longest prefix that fits, followed by "..." if the text was truncated.
std::string magnified_fitting(const Fonts& fonts, const TextStyle& style, std::string_view text,
                              float width);

}  // namespace wrinkle::editor
