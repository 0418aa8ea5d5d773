// Shapes, text and icons on an ImDrawList, in screen pixels.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "registry/port_type.h"

namespace wrinkle::editor {

inline ImVec2 operator+(ImVec2 a, ImVec2 b) {
    return {a.x + b.x, a.y + b.y};
}
inline ImVec2 operator-(ImVec2 a, ImVec2 b) {
    return {a.x - b.x, a.y - b.y};
}
inline ImVec2 operator*(ImVec2 a, float s) {
    return {a.x * s, a.y * s};
}

// A GL texture for ImGui's functions that draw images.
inline ImTextureID texture_id(uint32_t texture) {
    return reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture));
}

// Draws a pin in the shape of its type; `unit` is half its size. If not `filled`, it is an outline
// with `ground` inside.
void draw_pin(ImDrawList& list, PortType type, ImVec2 center, float unit, ImU32 color, bool filled,
              ImU32 ground);

// One line of text; `at` is its upper left corner, or the upper right one if right-aligned.
void draw_text(ImDrawList& list, ImFont* font, float size, ImVec2 at, ImU32 color,
               std::string_view text, bool right_aligned = false);
float text_width(ImFont* font, float size, std::string_view text);
// The longest prefix that fits, followed by "..." if the text was truncated.
std::string fitting(ImFont* font, float size, std::string_view text, float width);
// Breaks the text between words into at most `most` lines; a truncated last line ends with "...".
std::vector<std::string> wrapped(ImFont* font, float size, std::string_view text, float width,
                                 size_t most);

// A cubic Bezier curve from a to d.
struct Curve {
    ImVec2 a, b, c, d;
    ImVec2 at(float t) const;
};
Curve wire_curve(ImVec2 start, ImVec2 end, float zoom);

void draw_dashed(ImDrawList& list, const Curve& curve, ImU32 color, float thickness, float dash,
                 float gap);

// Draws a triangle with an exclamation mark.
void draw_warning(ImDrawList& list, ImVec2 center, float size, ImU32 color);
// Draws an octagon with an exclamation mark.
void draw_error(ImDrawList& list, ImVec2 center, float size, ImU32 color);

// Icons of 16 x 16 pixels, drawn as strokes, by name: "undo", "add-node", "fit", "check", ...
// Unknown names draw nothing.
void draw_icon(ImDrawList& list, std::string_view name, ImVec2 center, ImU32 color);

}  // namespace wrinkle::editor
