// Rows of the dialogs: a label and a control.
#pragma once

#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {

inline constexpr float label_wide = 96, dialog_row_tall = 36;

// Begins a row, or at `x` the right one of two controls, with a label that has a tooltip; the
// control is next.
void begin_control(const Fonts& fonts, const char* label, const char* tip = nullptr, float x = 0);

// Draws a control with a visible border, named `target` for scripts; returns the result of `draw`.
template <class Draw>
bool draw_control(Interface& interface, const std::string& target, float wide, Draw draw) {
    ImGui::SetNextItemWidth(wide);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    const bool result = draw();
    ImGui::PopStyleColor();
    name_item(interface, target);
    return result;
}

// Combo box of numbers; `word` returns the label of each.
template <class Numbers, class Word>
void draw_numbers(Interface& interface, const std::string& target, const Numbers& numbers,
                  uint32_t& chosen, float wide, Word word) {
    std::vector<Item> items;
    for (const uint32_t each : numbers)
        items.push_back({word(each), target + ":" + std::to_string(each)});
    const int picked = choose(interface, target, word(chosen), items, wide);
    if (picked >= 0) chosen = numbers[static_cast<size_t>(picked)];
}

// Combo box of a mesh: the shapes, the mesh of the preview, and files, which the browser of the
// purpose chooses. Targets begin with `prefix`.
void choose_mesh(State& state, const std::string& prefix, std::string& mesh, float wide,
                 Browser::Purpose purpose);

}  // namespace wrinkle::editor
