#include "editor/view/panels/prompt.h"

#include <imgui.h>

#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float prompt_width = 520, prompt_padding = 24;

void draw_words(Interface& interface, const Prompt& prompt) {
    constexpr float wrap = prompt_width - prompt_padding;
    ImGui::PushFont(interface.fonts.bold(18));
    write_paragraph(theme::text, prompt.title, wrap);
    ImGui::PopFont();
    write_paragraph(theme::text_dim, prompt.text, wrap);
    write_paragraph(theme::error, prompt.error, wrap);
}

// Returns the pressed button or nullptr.
const PromptButton* draw_buttons(Interface& interface, const std::vector<PromptButton>& buttons) {
    const PromptButton* pressed = nullptr;
    for (const PromptButton& each : buttons) {
        const bool first = &each == &buttons.front();
        if (!first) ImGui::SameLine();
        if (first) ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_fill);
        if (button(interface, each.label, each.target, false, {104, 28})) pressed = &each;
        if (first) ImGui::PopStyleColor();
    }
    // The key that led to the prompt does not answer it.
    if (ImGui::IsWindowAppearing()) return pressed;
    if (is_pressed(ImGuiKey_Escape)) return &buttons.back();
    return is_pressed(ImGuiKey_Enter) ? &buttons.front() : pressed;
}

}  // namespace

void draw_prompt(State& state, const char* id, const Prompt& prompt) {
    const Dialog dialog(id, {prompt_width, 0}, {prompt_padding, prompt_padding}, 8, 0.4F);
    if (!dialog) return;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 8));
    draw_words(state, prompt);
    ImGui::Dummy({0, 8});
    const PromptButton* pressed = draw_buttons(state, prompt.buttons);
    ImGui::PopStyleVar();
    if (!pressed) return;
    ImGui::CloseCurrentPopup();
    pressed->press(state);
}

}  // namespace wrinkle::editor
