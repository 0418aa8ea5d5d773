// Colors by role, and those of the port types, in two themes. The variables hold the colors of the
// current theme; use() switches all of them, between frames.
//
// Text has a contrast ratio of at least 4.5 on its backgrounds, graphical parts at least 3. Port
// types differ in shape (draw.h) and in color, also with color vision deficiencies
// (tests/editor/theme_test.cpp).
#pragma once

#include <imgui.h>

#include <array>
#include "registry/port_type.h"

namespace wrinkle::editor {

enum class Theme : uint8_t { dark, light };

}  // namespace wrinkle::editor

namespace wrinkle::editor::theme {

constexpr ImU32 rgb(unsigned hex) {
    return IM_COL32(hex >> 16 & 255, hex >> 8 & 255, hex & 255, 255);
}
constexpr ImU32 with_alpha(ImU32 color, float alpha) {
    return (color & ~IM_COL32_A_MASK) | static_cast<ImU32>(alpha * 255) << IM_COL32_A_SHIFT;
}

// name, dark, light
#define WRINKLE_THEME_COLORS(X)           \
    X(canvas, 0x15171B, 0xF1F2F4)         \
    X(grid, 0x2C313A, 0xD3D7DC)           \
    X(panel, 0x1D2025, 0xFAFBFC)          \
    X(bar, 0x23272E, 0xE9EBEE)            \
    X(node, 0x262A31, 0xFFFFFF)           \
    X(header, 0x2F343D, 0xEBEEF2)         \
    X(field, 0x16191D, 0xF3F5F7)          \
    X(border, 0x363C46, 0xCBD0D7)         \
    X(line, 0x606977, 0x848C98)           \
    X(control, 0x7C8696, 0x757D89)        \
    X(text, 0xE9ECF1, 0x1A1D21)           \
    X(text_dim, 0xB0B8C4, 0x4F5761)       \
    X(text_off, 0x77808D, 0x7D8591)       \
    X(accent, 0x6FB3FF, 0x1A5DBC)         \
    X(accent_fill, 0x2A68BD, 0x1F62BD)    \
    X(accent_soft, 0x24405F, 0xD3E3F8)    \
    X(warn, 0xF5B83D, 0x7F5200)           \
    X(error, 0xFF8078, 0xB3261E)          \
    X(ok, 0x5CC98B, 0x1B7040)             \
    X(code, 0x181B20, 0xFAFBFC)           \
    X(code_highlight, 0x1E3049, 0xE2ECFA) \
    X(code_text, 0xD7DCE4, 0x22262B)      \
    X(code_comment, 0x97A2B2, 0x5A636E)   \
    X(code_keyword, 0x8FB8FF, 0x1F4FB8)   \
    X(code_type, 0x6CCFC4, 0x00665E)      \
    X(code_function, 0xE9C77B, 0x7A4E00)  \
    X(code_number, 0xF2A68C, 0xA33A16)    \
    X(on_accent, 0xFFFFFF, 0xFFFFFF)

#define X(name, dark, light) inline ImU32 name = rgb(dark);
WRINKLE_THEME_COLORS(X)
#undef X
inline ImU32 shadow = IM_COL32(0, 0, 0, 71);  // cards and popups; transparent in the light theme

ImU32 of(PortType type);

void use(Theme theme);  // also sets ImGui's style if there is a context
Theme used();

}  // namespace wrinkle::editor::theme

namespace wrinkle::editor {

// Color scale from low to high: cividis, uniform and monotone also with color vision deficiencies.
inline constexpr std::array<unsigned, 10> heat_stops = {0x00224E, 0x123570, 0x3B496C, 0x575D6D,
                                                        0x707173, 0x8A8678, 0xA59C74, 0xC3B369,
                                                        0xE1CC55, 0xFEE838};

struct HeatColor {
    ImU32 ground;
    ImU32 text;  // black or white, whichever has more contrast on it
};
HeatColor heat_color(float part);  // 0 to 1

}  // namespace wrinkle::editor
