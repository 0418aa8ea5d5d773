// Widgets shared by all panels.
#include <cmath>

#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float icon_side = 24;

}  // namespace

FixedWindow::FixedWindow(const char* id, ImVec2 at, ImVec2 size, ImGuiWindowFlags flags,
                         ImU32 color, ImVec2 padding) {
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, color);
    ImGui::Begin(id, nullptr,
                 flags | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNavInputs);
}

FixedWindow::~FixedWindow() {
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

void name_area(Interface& interface, const std::string& target, ImVec2 low, ImVec2 high) {
    interface.targets.add(target, {low.x, low.y, high.x, high.y});
}

void name_item(Interface& interface, const std::string& target) {
    name_area(interface, target, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

bool is_pressed(ImGuiKey key, bool repeat) {
    return ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[key], repeat);
}

int moved_choice(int chosen, size_t count, int page) {
    chosen += is_pressed(ImGuiKey_DownArrow) - is_pressed(ImGuiKey_UpArrow);
    chosen += page * (is_pressed(ImGuiKey_PageDown) - is_pressed(ImGuiKey_PageUp));
    return std::clamp(chosen, 0, std::max(static_cast<int>(count) - 1, 0));
}

void write_paragraph(ImU32 color, const std::string& text, float wrap) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(wrap);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

bool button(Interface& interface, const char* label, const std::string& target, bool chosen,
            ImVec2 size) {
    if (chosen) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_soft);
        ImGui::PushStyleColor(ImGuiCol_Border, theme::accent);
    }
    const bool pressed = ImGui::Button(label, size);
    if (chosen) ImGui::PopStyleColor(2);
    name_item(interface, target);
    return pressed;
}

bool icon_button(Interface& interface, const char* icon, const std::string& target,
                 const std::string& tooltip, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::InvisibleButton(target.c_str(), {icon_side, icon_side});
    ImGui::EndDisabled();
    name_item(interface, target);
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

int segments(Interface& interface, std::span<const Segment> all, int chosen, float width) {
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
        name_item(interface, all[i].target);
        const bool own = static_cast<int>(i) == chosen, hovered = ImGui::IsItemHovered();
        if (own || hovered) list.AddRectFilled(low, high, theme::accent_soft, 5);
        if (own) list.AddRect(low, high, theme::accent, 5);
        if (hovered && !all[i].tooltip.empty()) show_tooltip({low, high}, all[i].tooltip);
        ImFont* font = own ? interface.fonts.bold(16) : interface.fonts.regular(16);
        const std::string label = fitting(font, 16, all[i].label, each - 4);
        const float x = low.x + (each - text_width(font, 16, label)) / 2;
        draw_text(list, font, 16, {x, low.y + 4}, own ? theme::text : theme::text_dim, label);
    }
    return picked;
}

namespace {

// Returns true while the list of the combo box is open: then add the items and call
// ImGui::EndCombo().
bool begin_choice(Interface& interface, const std::string& target, const std::string& shown,
                  float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = low + ImVec2(width, ImGui::GetFrameHeight());
    const bool enabled = ImGui::GetStyle().Alpha > 0.99F;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string fitted = fitting(interface.fonts.regular(16), 16, shown, width - 32);
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 8));
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    const bool open =
        ImGui::BeginCombo(("##" + target).c_str(), fitted.c_str(), ImGuiComboFlags_NoArrowButton);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    draw_icon(list, "down", {high.x - 14, (low.y + high.y) / 2},
              enabled ? theme::text_dim : theme::text_off);
    name_area(interface, target, low, high);
    return open;
}

}  // namespace

int choose(Interface& interface, const std::string& target, const std::string& shown,
           const Choices& choices, float width) {
    int picked = -1;
    if (!begin_choice(interface, target, shown, width)) return picked;
    for (size_t i = 0; i < choices.labels.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(choices.labels[i].c_str(), choices.chosen == static_cast<int>(i)))
            picked = static_cast<int>(i);
        ImGui::PopID();
        name_item(interface, choices.targets[i]);
    }
    ImGui::EndCombo();
    return picked;
}

void focus_field(Dialogs& dialogs) {
    constexpr int max_frames = 6;
    ImGui::SetKeyboardFocusHere();
    dialogs.field_wait = max_frames;
}

void note_field(Dialogs& dialogs) {
    if (ImGui::IsItemActive()) dialogs.field_wait = 0;
}

bool typing_waits(const Dialogs& dialogs) {
    const bool browsing =
        dialogs.browser.purpose != Browser::Purpose::none && dialogs.browser.focus;
    return dialogs.field_wait > 0 || browsing || dialogs.popup.opening || dialogs.palette.opening ||
           dialogs.box_text.opening;
}

void age_field_wait(Dialogs& dialogs) {
    dialogs.field_wait = std::max(dialogs.field_wait - 1, 0);
}

}  // namespace wrinkle::editor
