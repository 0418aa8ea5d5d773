// Widgets shared by all panels.
#include <cmath>

#include "editor/view/look/draw.h"
#include "editor/view/look/icons.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float icon_side = 24;

}  // namespace

void name_item(State& state, const std::string& target) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    state.targets.add(target, {low.x, low.y, high.x, high.y});
}

bool button(State& state, const char* label, const std::string& target, bool chosen, ImVec2 size) {
    if (chosen) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_soft);
        ImGui::PushStyleColor(ImGuiCol_Border, theme::accent);
    }
    const bool pressed = ImGui::Button(label, size);
    if (chosen) ImGui::PopStyleColor(2);
    name_item(state, target);
    return pressed;
}

bool icon_button(State& state, const char* icon, const std::string& target,
                 const std::string& tooltip, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::InvisibleButton(target.c_str(), {icon_side, icon_side});
    ImGui::EndDisabled();
    name_item(state, target);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (enabled && (hovered || ImGui::IsItemActive()))
        list.AddRectFilled(low, high,
                           ImGui::IsItemActive() ? theme::accent_fill : theme::accent_soft, 5);
    draw_icon(list, icon, (low + high) * 0.5F, enabled ? theme::text : theme::text_off);
    if (hovered) show_tooltip(last_item(), tooltip);
    return pressed;
}

int segments(State& state, std::span<const Segment> all, int chosen, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float each = std::floor(width / static_cast<float>(all.size()));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 whole(each * static_cast<float>(all.size()), icon_side);
    list.AddRectFilled(at, at + whole, theme::field, 5);
    list.AddRect(at, at + whole, theme::border, 5);
    int picked = -1;
    for (size_t i = 0; i < all.size(); ++i) {
        const ImVec2 low = at + ImVec2(each * static_cast<float>(i), 0);
        const ImVec2 high = low + ImVec2(each, icon_side);
        ImGui::SetCursorScreenPos(low);
        if (ImGui::InvisibleButton(all[i].target.c_str(), high - low)) picked = static_cast<int>(i);
        name_item(state, all[i].target);
        const bool own = static_cast<int>(i) == chosen, hovered = ImGui::IsItemHovered();
        if (own || hovered) list.AddRectFilled(low, high, theme::accent_soft, 5);
        if (own) list.AddRect(low, high, theme::accent, 5);
        if (hovered && !all[i].tooltip.empty()) show_tooltip({low, high}, all[i].tooltip);
        ImFont* font = own ? state.fonts.bold(16) : state.fonts.regular(16);
        const std::string label = fitting(font, 16, all[i].label, each - 4);
        const float x = low.x + (each - text_width(font, 16, label)) / 2;
        draw_text(list, font, 16, {x, low.y + 4}, own ? theme::text : theme::text_dim, label);
    }
    return picked;
}

bool begin_choice(State& state, const char* id, const std::string& target, const std::string& shown,
                  float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = low + ImVec2(width, ImGui::GetFrameHeight());
    const bool enabled = ImGui::GetStyle().Alpha > 0.99F;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string fitted = fitting(state.fonts.regular(16), 16, shown, width - 32);
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 8));
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    const bool open = ImGui::BeginCombo(id, fitted.c_str(), ImGuiComboFlags_NoArrowButton);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    draw_icon(list, "down", {high.x - 14, (low.y + high.y) / 2},
              enabled ? theme::text_dim : theme::text_off);
    state.targets.add(target, {low.x, low.y, high.x, high.y});
    return open;
}

}  // namespace wrinkle::editor
