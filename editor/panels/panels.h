// The panels round the canvas: each fills the ImGui window or child that is current.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_menu_bar(State& state);
void draw_toolbar(State& state);
void draw_status_bar(State& state);
void draw_overlays(State& state);
void draw_preview(State& state);
void draw_code(State& state);
void draw_problems(State& state);
float problems_height(const State& state);
void next_problem(State& state);                   // frames its node
std::string_view no_problems(const State& state);  // "" when there is one

// Gives the ImGui item that was drawn last a name for scripts.
void name_item(State& state, const std::string& target);

std::string counted(size_t number, const char* what);  // "1 node", "2 nodes"

// A button that scripts know by `target`; `chosen` marks the one that holds.
bool button(State& state, const char* label, const std::string& target, bool chosen = false,
            ImVec2 size = {0, 0});

}  // namespace wrinkle::editor
