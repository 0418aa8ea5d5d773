// The panels round the canvas: each fills the ImGui window or child that is current.
#pragma once

#include <span>

#include "editor/state.h"
#include "editor/words.h"

namespace wrinkle::editor {

void draw_menu_bar(State& state);
void draw_toolbar(State& state);
void draw_status_bar(State& state, const struct Regions& regions);
void draw_overlays(State& state);
void draw_preview(State& state);
void draw_code(State& state);
void draw_problems(State& state);
void draw_task(State& state);
float problems_height(const State& state);
void next_problem(State& state);                   // frames its node
std::string_view no_problems(const State& state);  // "" when there is one

// Gives the ImGui item that was drawn last a name for scripts.
void name_item(State& state, const std::string& target);

// A button that scripts know by `target`; `chosen` marks the one that holds.
bool button(State& state, const char* label, const std::string& target, bool chosen = false,
            ImVec2 size = {0, 0});
// One of 24 pixels with an icon in place of words, which its tooltip says.
bool icon_button(State& state, const char* icon, const std::string& target,
                 const std::string& tooltip, bool enabled = true);

// Choices side by side, one of which holds; the index that was picked, or -1.
struct Segment {
    std::string label, target, tooltip = {};
};
int segments(State& state, std::span<const Segment> all, int chosen, float width);

// The box of a list to choose from; true while the list is open: fill it, then ImGui::EndCombo().
bool begin_choice(State& state, const char* id, const std::string& target, const std::string& shown,
                  float width);

}  // namespace wrinkle::editor
