// How the window is divided: what the user has changed about it. Fractions, so that they hold at
// every size; 0 means the rule of regions.h.
#pragma once

#include <cstdint>
#include <optional>

namespace wrinkle::editor {

enum class Pane : uint8_t { none, canvas, problems, preview, code };

struct Panes {
    float side = 0;                  // the column at the right: of the window's width
    float preview = 0;               // the preview: of the column's height
    float problems = 0;              // of the work area's height
    std::optional<bool> side_shown;  // nothing: when the window is wide enough
    Pane maximised = Pane::none;
};

}  // namespace wrinkle::editor
