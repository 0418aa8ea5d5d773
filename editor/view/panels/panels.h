// Functions that panels share. ui.cpp has the table of panels.
#pragma once

#include <span>

#include "editor/model/words.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

void draw_recent_files(State& state);  // rows of the File menu

// Returns true if there is no file, node or undo step, and no empty graph was requested.
bool is_at_start(const State& state);
float problems_height(const State& state);
void next_problem(State& state);                   // shows its message and frames its node
std::string_view no_problems(const State& state);  // a sentence if there are none, else ""

// Registers the ImGui item drawn last as `target` for scripts.
void name_item(State& state, const std::string& target);

// Button, named `target` for scripts; `chosen` highlights it. Returns true if pressed.
bool button(State& state, const char* label, const std::string& target, bool chosen = false,
            ImVec2 size = {0, 0});
// Button of 24 x 24 pixels with an icon instead of a label; `tooltip` describes it.
bool icon_button(State& state, const char* icon, const std::string& target,
                 const std::string& tooltip, bool enabled = true);

// Row of segments, of which `chosen` is active. Returns the index that was clicked, or -1.
struct Segment {
    std::string label, target, tooltip = {};
};
int segments(State& state, std::span<const Segment> all, int chosen, float width);

// Combo box. Returns true while its list is open: then add the items and call ImGui::EndCombo().
bool begin_choice(State& state, const char* id, const std::string& target, const std::string& shown,
                  float width);

}  // namespace wrinkle::editor
