// Where the parts of the window stand, in logical pixels: menu bar, toolbar, work area, status bar;
// in the work area the canvas over the problems, and at the right the preview over the code.
//
//   side column   30 % of the width, a multiple of 8, 400 to 768; folded away below 960
//   preview       its bars and a picture of 18:13, at most 56 % of the work area
//   problems      as high as its rows, at most 20 %; its header alone in a window below 800
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

struct Rect {
    ImVec2 at{0, 0}, size{0, 0};
    bool contains(ImVec2 point) const {
        return point.x >= at.x && point.y >= at.y && point.x < at.x + size.x &&
               point.y < at.y + size.y;
    }
};

struct Regions {
    Rect menu, tools, work, task, status;
    Rect canvas, problems, preview, code;  // of no size: not shown
    const Rect& of(Pane pane) const;
    Pane at(ImVec2 point) const;
};

inline constexpr float task_height = 40;

// `problems` is the height that all rows of the problems would take; `task` that of the strip of
// what runs in the background.
Regions find_regions(const Panes& panes, ImVec2 window, float problems, float task = 0);
// Those of this frame.
Regions regions_of(const State& state);

// The lines between the parts, to be dragged; a double click gives the rule back.
void draw_splitters(Panes& panes, const Regions& regions);

}  // namespace wrinkle::editor
