// Theme and scale of the interface. Panels do not use the scale: all coordinates are logical
// pixels; `scale` device pixels are one logical pixel.
#pragma once

#include <imgui.h>

#include "editor/view/look/fonts.h"
#include "editor/view/look/theme.h"

namespace wrinkle::editor {

inline constexpr float interface_scales[] = {1, 1.25F, 1.5F, 2, 3};

struct Look {
    Theme theme = Theme::dark;
    float scale = 1;  // one of interface_scales
};

// Applies theme and fonts; call between frames. Returns true if the fonts were baked again and the
// atlas texture has to be replaced.
bool apply_look(const Look& look, Fonts& fonts);

// The next larger scale (`by` > 0), else the next smaller one; unchanged at either end.
float next_scale(float scale, int by);

// Snaps glyphs of ImGui's own text, which are at integer logical pixels, to integer device pixels.
// Does nothing for an integer scale.
void sharpen(ImDrawData& data, float scale);

}  // namespace wrinkle::editor
