// How the whole interface looks: its theme and its scale. Panels never ask for the scale: all
// coordinates are logical pixels, `scale` of which make a pixel of the screen.
#pragma once

#include <imgui.h>

#include "editor/look/fonts.h"
#include "editor/look/theme.h"

namespace wrinkle::editor {

inline constexpr float interface_scales[] = {1, 1.25F, 1.5F, 2, 3};

struct Look {
    Theme theme = Theme::dark;
    float scale = 1;  // one of interface_scales
};

// Brings colours and letters to the look, between frames. True when the letters were baked anew:
// their texture is another.
bool apply_look(const Look& look, Fonts& fonts);

// The next larger scale (`by` > 0) or the next smaller one; the same at the ends.
float next_scale(float scale, int by);

// Moves letters of ImGui's own texts, which stand at whole logical pixels, to whole pixels of the
// screen. Those that stand there already stay.
void sharpen(ImDrawData& data, float scale);

}  // namespace wrinkle::editor
