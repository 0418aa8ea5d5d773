// Layout of the window in logical pixels: menu bar, toolbar, work area, task strip, status bar. In
// the work area: the canvas above the problems; in the side column, the preview above the code.
//
//   side column   30 % of the width, a multiple of 8, 400 to 768; hidden if the window is below 960
//   preview       its bars and an image with aspect ratio 18:13, at most 56 % of the work area's
//                 height
//   problems      height of its rows, at most 20 % of the work area's height; only its header in
//                 windows lower than 800
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>

namespace wrinkle::editor {

struct State;

enum class Pane : uint8_t { none, canvas, problems, preview, code };

// Window layout as changed by the user. Sizes are fractions, so that they apply to every window
// size; 0 means the default rule above.
struct Panes {
    float side = 0;                  // right column; fraction of the window width
    float preview = 0;               // fraction of the column height
    float problems = 0;              // fraction of the work area height
    std::optional<bool> side_shown;  // std::nullopt: shown if the window is wide enough
    Pane maximised = Pane::none;
};

struct Rect {
    ImVec2 at{0, 0}, size{0, 0};
    ImVec2 end() const { return {at.x + size.x, at.y + size.y}; }
    bool contains(ImVec2 point) const {
        return point.x >= at.x && point.y >= at.y && point.x < end().x && point.y < end().y;
    }
};

struct Regions {
    Rect menu, tools, work, task, status;
    Rect canvas, problems, preview, code;  // size 0: not shown
    const Rect& of(Pane pane) const;
    Pane at(ImVec2 point) const;
};

inline constexpr float task_height = 40;

// `problems`: height of the problems panel with all rows; `task`: height of the task strip.
Regions find_regions(const Panes& panes, ImVec2 window, float problems, float task = 0);
// Returns the regions of the current frame.
Regions regions_of(const State& state);

}  // namespace wrinkle::editor
