// Widgets shared by all panels.
#include <algorithm>
#include <cmath>

#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float icon_side = 24;
constexpr ImGuiWindowFlags frameless = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

// Returns true if the row of a list was clicked.
bool draw_item(const Interface& interface, const Item& item, bool chosen) {
    if (!item.image) return ImGui::Selectable(item.label.c_str(), chosen);
    constexpr float side = 40, gap = 8;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool picked = ImGui::Selectable("##item", chosen, 0, {0, side});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (*item.image)
        list.AddImage(texture_id(*item.image), at, at + ImVec2(side, side), {0, 1}, {1, 0});
    draw_text(list, interface.fonts.regular(16), 16, at + ImVec2(side + gap, side / 2 - 8),
              theme::text, item.label);
    return picked;
}

}  // namespace

FixedWindow::FixedWindow(const char* id, ImVec2 at, ImVec2 size, const WindowStyle& style)
    : opening_(style.opening) {
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    if (opening_) ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, style.padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, style.rounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, style.border ? 1.0F : 0.0F);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, style.ground);
    ImGui::PushStyleColor(ImGuiCol_Border, style.border ? style.border : theme::border);
    ImGui::Begin(id, nullptr, style.flags | frameless);
}

FixedWindow::~FixedWindow() {
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(4);
}

bool FixedWindow::has_lost_focus() const {
    return !opening_ && !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
}

Dialog::Dialog(const char* id, ImVec2 size, ImVec2 padding, float rounding, float y) {
    if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({room.x / 2, room.y * y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, rounding);
    shown_ = ImGui::BeginPopupModal(id, nullptr, frameless);
}

Dialog::~Dialog() {
    if (shown_) ImGui::EndPopup();
    ImGui::PopStyleVar(2);
}

PanelPopup::PanelPopup(const char* id) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12, 12));
    shown_ = ImGui::BeginPopup(id);
    ImGui::PopStyleVar();
    const bool covered = shown_ && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    left_ = shown_ && !covered && is_pressed(ImGuiKey_Escape, false);
    if (left_) ImGui::CloseCurrentPopup();
}

PanelPopup::~PanelPopup() {
    if (shown_) ImGui::EndPopup();
}

void name_area(Interface& interface, const std::string& target, ImVec2 low, ImVec2 high) {
    interface.targets.add(target, {low.x, low.y, high.x, high.y});
}

void name_item(Interface& interface, const std::string& target) {
    name_area(interface, target, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

bool press_area(const char* id, ImVec2 size, ImGuiButtonFlags flags) {
    return ImGui::InvisibleButton(id, {std::max(size.x, 1.0F), std::max(size.y, 1.0F)}, flags);
}

Area area_button(Interface& interface, const std::string& target, ImVec2 size) {
    const bool pressed = press_area(target.c_str(), size);
    name_item(interface, target);
    return {ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), pressed,
            ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)};
}

bool is_pressed(ImGuiKey key, bool repeat) {
    return ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[key], repeat);
}

int moved_choice(int chosen, size_t count, int page) {
    chosen += is_pressed(ImGuiKey_DownArrow) - is_pressed(ImGuiKey_UpArrow);
    chosen += page * (is_pressed(ImGuiKey_PageDown) - is_pressed(ImGuiKey_PageUp));
    return std::clamp(chosen, 0, std::max(static_cast<int>(count) - 1, 0));
}

std::string percent(float part) {
    return std::to_string(std::lround(part * 100)) + " %";
}

void write_paragraph(ImU32 color, const std::string& text, float wrap) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(wrap);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

bool draw_strip(const Fonts& fonts, ImVec2 at, float width, ImU32 ground, ImU32 mark,
                const std::string& text) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, at + ImVec2(width, strip_tall), ground);
    list.AddRectFilled(at, at + ImVec2(4, strip_tall), mark);
    ImFont* font = fonts.regular(14);
    const std::string shown = fitting(font, 14, text, width - 20);
    draw_text(list, font, 14, at + ImVec2(12, 7), theme::text, shown);
    return shown == text;
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
    const Area area = area_button(interface, target, {icon_side, icon_side});
    ImGui::EndDisabled();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (enabled && (area.hovered || ImGui::IsItemActive()))
        list.AddRectFilled(area.low, area.high,
                           ImGui::IsItemActive() ? theme::accent_fill : theme::accent_soft, 5);
    draw_icon(list, icon, (area.low + area.high) * 0.5F, enabled ? theme::text : theme::text_off);
    if (area.hovered) show_tooltip(last_item(), tooltip);
    return area.pressed;
}

int segments(Interface& interface, std::span<const Item> items, int chosen, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float each = std::floor(width / static_cast<float>(items.size()));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 whole(each * static_cast<float>(items.size()), icon_side);
    list.AddRectFilled(at, at + whole, theme::field, 5);
    list.AddRect(at, at + whole, theme::border, 5);
    int picked = -1;
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
        const Item& item = items[static_cast<size_t>(i)];
        if (i > 0) ImGui::SameLine(0, 0);
        const auto [low, high, pressed, hovered] =
            area_button(interface, item.target, {each, icon_side});
        if (pressed) picked = i;
        const bool own = i == chosen;
        if (own || hovered) list.AddRectFilled(low, high, theme::accent_soft, 5);
        if (own) list.AddRect(low, high, theme::accent, 5);
        if (hovered && !item.tooltip.empty()) show_tooltip({low, high}, item.tooltip);
        ImFont* font = own ? interface.fonts.bold(16) : interface.fonts.regular(16);
        const std::string label = fitting(font, 16, item.label, each - 4);
        const float x = low.x + (each - text_width(font, 16, label)) / 2;
        draw_text(list, font, 16, {x, low.y + 4}, own ? theme::text : theme::text_dim, label);
    }
    return picked;
}

int choose(Interface& interface, const std::string& target, const std::string& shown,
           std::span<const Item> items, float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = low + ImVec2(width, ImGui::GetFrameHeight());
    const bool enabled = ImGui::GetStyle().Alpha > 0.99F;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string fitted = fitting(interface.fonts.regular(16), 16, shown, width - 32);
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 8));
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    const bool open =
        ImGui::BeginCombo(("##" + target).c_str(), fitted.c_str(),
                          ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLarge);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    draw_icon(list, "down", {high.x - 14, (low.y + high.y) / 2},
              enabled ? theme::text_dim : theme::text_off);
    name_area(interface, target, low, high);
    if (!open) return -1;
    if (is_pressed(ImGuiKey_Escape, false)) ImGui::CloseCurrentPopup();
    int picked = -1;
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
        const Item& item = items[static_cast<size_t>(i)];
        ImGui::PushID(i);
        if (draw_item(interface, item, item.label == shown)) picked = i;
        ImGui::PopID();
        name_item(interface, item.target);
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

void note_held(Dialogs& dialogs) {
    dialogs.holds_value |= ImGui::IsItemActive();
}

void age_field_wait(Dialogs& dialogs) {
    dialogs.field_wait = std::max(dialogs.field_wait - 1, 0);
}

}  // namespace wrinkle::editor
