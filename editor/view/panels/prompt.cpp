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

std::optional<size_t> draw_buttons(Interface& interface, const std::vector<PromptButton>& buttons) {
    std::optional<size_t> pressed;
    for (size_t i = 0; i < buttons.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        if (i == 0) ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_fill);
        if (button(interface, buttons[i].label, buttons[i].target, false, {104, 28})) pressed = i;
        if (i == 0) ImGui::PopStyleColor();
    }
    // The key that led to the prompt does not answer it.
    if (ImGui::IsWindowAppearing()) return pressed;
    if (is_pressed(ImGuiKey_Escape)) return buttons.size() - 1;
    return is_pressed(ImGuiKey_Enter) ? 0 : pressed;
}

}  // namespace

std::optional<size_t> draw_prompt(Interface& interface, const char* id, const Prompt& prompt) {
    const Dialog dialog(id, {prompt_width, 0}, {prompt_padding, prompt_padding}, 8, 0.4F);
    if (!dialog) return {};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 8));
    draw_words(interface, prompt);
    ImGui::Dummy({0, 8});
    const std::optional<size_t> pressed = draw_buttons(interface, prompt.buttons);
    ImGui::PopStyleVar();
    if (pressed) ImGui::CloseCurrentPopup();
    return pressed;
}

}  // namespace wrinkle::editor
