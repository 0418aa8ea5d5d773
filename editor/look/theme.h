// The dark theme: colours by role, and those of the types on wires.
#pragma once

#include <imgui.h>

#include "registry/port_type.h"

namespace wrinkle::editor::theme {

constexpr ImU32 rgb(unsigned hex) {
    return IM_COL32(hex >> 16 & 255, hex >> 8 & 255, hex & 255, 255);
}
constexpr ImU32 with_alpha(ImU32 color, float alpha) {
    return (color & ~IM_COL32_A_MASK) | static_cast<ImU32>(alpha * 255) << IM_COL32_A_SHIFT;
}

inline constexpr ImU32 canvas = rgb(0x15171B), grid = rgb(0x2C313A);
inline constexpr ImU32 panel = rgb(0x1D2025), bar = rgb(0x23272E);
inline constexpr ImU32 node = rgb(0x262A31), header = rgb(0x2F343D), field = rgb(0x16191D);
inline constexpr ImU32 border = rgb(0x363C46), line = rgb(0x606977), control = rgb(0x7C8696);
inline constexpr ImU32 text = rgb(0xE9ECF1), text_dim = rgb(0xB0B8C4), text_off = rgb(0x77808D);
inline constexpr ImU32 accent = rgb(0x6FB3FF), accent_fill = rgb(0x2A68BD);
inline constexpr ImU32 accent_soft = rgb(0x24405F);
inline constexpr ImU32 warn = rgb(0xF5B83D), error = rgb(0xFF8078), ok = rgb(0x5CC98B);
inline constexpr ImU32 code = rgb(0x181B20), code_highlight = rgb(0x1E3049);
inline constexpr ImU32 code_text = rgb(0xD7DCE4), code_comment = rgb(0x97A2B2);
inline constexpr ImU32 code_keyword = rgb(0x8FB8FF), code_type = rgb(0x6CCFC4);
inline constexpr ImU32 code_function = rgb(0xE9C77B), code_number = rgb(0xF2A68C);

ImU32 of(PortType type);

void apply_style();  // to ImGui's own widgets

}  // namespace wrinkle::editor::theme
