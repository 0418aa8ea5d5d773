// Window layout as changed by the user. Sizes are fractions, so that they apply to every window
// size; 0 means the default rule of regions.h.
#pragma once

#include <cstdint>
#include <optional>

namespace wrinkle::editor {

enum class Pane : uint8_t { none, canvas, problems, preview, code };

struct Panes {
    float side = 0;                  // right column; fraction of the window width
    float preview = 0;               // fraction of the column height
    float problems = 0;              // fraction of the work area height
    std::optional<bool> side_shown;  // std::nullopt: shown if the window is wide enough
    Pane maximised = Pane::none;
};

}  // namespace wrinkle::editor
