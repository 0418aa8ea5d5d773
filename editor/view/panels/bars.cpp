// Menu bar and toolbar.
#include <algorithm>
#include <cmath>

#include "editor/view/commands/commands.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float wordless = 1100;   // below this width toolbar buttons have no label
constexpr float min_search = 640;  // below this one neither has the search field

// Tooltip of a command: its title, its keys, and why it cannot be run now.
void explain(const State& state, const Command& command, const About& about) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const std::string keys(command.keys), why(command.why_not(state));
    show_tooltip(about, std::string(command.title) + (keys.empty() ? "" : "   ") + keys +
                            (why.empty() ? "" : "\n") + why);
}

void draw_menu_item(State& state, const Command& command) {
    const bool enabled = command.enabled(state);
    const std::string title = "     " + std::string(command.title), keys(command.keys);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushStyleColor(ImGuiCol_TextDisabled, theme::text_dim);
    const bool chosen = ImGui::MenuItem(title.c_str(), keys.c_str(), false, enabled);
    ImGui::PopStyleColor();
    name_item(state, "menu:" + std::string(command.id));
    const bool on = command.on && command.on(state);
    const ImU32 color = enabled ? theme::text_dim : theme::text_off;
    draw_icon(*ImGui::GetWindowDrawList(), on ? "check" : command.id, at + ImVec2(8, 8), color);
    if (!enabled) explain(state, command, beside_window());
    if (chosen) command.run(state);
}

void draw_menu(State& state, std::string_view name) {
    const std::string menu(name);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 8));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(10, 10));
    const bool open = ImGui::BeginMenu(menu.c_str());
    name_item(state, "menu:" + menu);
    if (open) {
        for (const Command& command : commands())
            if (command.menu == menu) draw_menu_item(state, command);
        if (menu == "File") draw_recent_files(state);
        if (is_pressed(ImGuiKey_Escape, false)) ImGui::CloseCurrentPopup();
        ImGui::EndMenu();
    }
    ImGui::PopStyleVar(2);
}

// Returns the width of the search field in the menu bar.
float search_room() {
    const float window = ImGui::GetWindowSize().x;
    return window < min_search ? 46.0F : window < wordless ? 168.0F : 272.0F;
}

// Draws the field at the right of the menu bar that opens the list of commands; returns its left x.
float draw_command_search(State& state) {
    const Command& search = *find_command("commands");
    const float window = ImGui::GetWindowSize().x;
    const bool words = window >= min_search;
    const float wide = search_room() - 16, left = window - wide - 8;
    ImGui::SetCursorPos({left, 3});
    const auto [low, high, pressed, hovered] = area_button(state, "search", {wide, 22});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::field, 4);
    list.AddRect(low, high, hovered ? theme::accent : theme::control, 4);
    draw_icon(list, "find", low + ImVec2(15, 11), theme::text_dim);
    ImFont* font = state.fonts.regular(14);
    if (words) draw_text(list, font, 14, low + ImVec2(30, 4), theme::text_dim, "Search commands");
    if (window >= wordless)
        draw_text(list, font, 14, {high.x - 8, low.y + 4}, theme::text_dim, search.keys, true);
    if (window < wordless) explain(state, search, last_item());
    if (pressed) search.run(state);
    return left;
}

void draw_title(const State& state, float from, float to) {
    const std::string file = state.file_name() + (state.dirty() ? ", edited" : "");
    const std::string& name = state.document().name;
    ImFont *bold = state.fonts.bold(16), *small = state.fonts.regular(14);
    const float gap = name.empty() ? 0 : 10;
    const float rest = text_width(small, 14, file) + gap;
    const std::string shown = fitting(bold, 16, name, std::max(to - from - rest - 32, 40.0F));
    const float whole = text_width(bold, 16, shown) + rest;
    if (whole > to - from - 16) return;
    const float middle = ImGui::GetWindowSize().x / 2;
    const float x = std::clamp(middle - whole / 2, from + 8, to - whole - 8);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, bold, 16, {x, 6}, theme::text, shown);
    draw_text(list, small, 14, {x + whole - rest + gap, 7}, theme::text_dim, file);
}

struct Tool {
    const char* id;     // command id
    const char* words;  // "": only the icon
    bool framed = false, primary = false;
};

// Returns the keys that are drawn after the words; "" for none.
std::string_view keys_of(const Tool& tool) {
    return tool.framed && !tool.primary ? find_command(tool.id)->keys : "";
}

float width_of(const Interface& interface, const Tool& tool, bool words) {
    if (!words || !tool.words[0]) return 28;
    const std::string_view keys = keys_of(tool);
    const float width = text_width(interface.fonts.regular(16), 16, tool.words) +
                        text_width(interface.fonts.regular(14), 14, keys);
    return std::ceil(28 + 12 + width + (keys.empty() ? 0 : 8));
}

void paint_tool(const Interface& interface, const Tool& tool, bool words, bool enabled,
                const Area& area) {
    const ImVec2 low = area.low, high = area.high;
    const bool hovered = enabled && area.hovered, held = ImGui::IsItemActive();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (tool.primary || hovered || held)
        list.AddRectFilled(low, high,
                           tool.primary || held ? theme::accent_fill : theme::accent_soft, 5);
    if (tool.framed && !tool.primary) list.AddRect(low, high, theme::border, 5);
    ImU32 color = tool.primary ? theme::on_accent : theme::text;
    if (!enabled) color = theme::text_off;
    draw_icon(list, tool.id, {low.x + 14, (low.y + high.y) / 2}, color);
    if (!words || !tool.words[0]) return;
    draw_text(list, interface.fonts.regular(16), 16, low + ImVec2(28, 6), color, tool.words);
    draw_text(list, interface.fonts.regular(14), 14, {high.x - 10, low.y + 7}, theme::text_dim,
              keys_of(tool), true);
}

void draw_tool(State& state, const Tool& tool, bool words) {
    const Command& command = *find_command(tool.id);
    const bool enabled = command.enabled(state);
    const ImVec2 size(width_of(state, tool, words), 28);
    ImGui::BeginDisabled(!enabled);
    const Area area = area_button(state, std::string("tool:") + tool.id, size);
    ImGui::EndDisabled();
    paint_tool(state, tool, words, enabled, area);
    explain(state, command, last_item());
    if (area.pressed) command.run(state);
    ImGui::SameLine(0, 4);
}

void draw_divider() {
    const ImVec2 at = ImGui::GetCursorScreenPos() + ImVec2(4, 4);
    ImGui::GetWindowDrawList()->AddLine(at, at + ImVec2(0, 20), theme::border);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 9);
}

}  // namespace

void draw_menu_bar(State& state) {
    ImGui::SetCursorPos({4, 2});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::line);
    ImGui::BeginChild("##bar", {ImGui::GetWindowSize().x - search_room(), 0}, false,
                      ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar);
    float end = 0;
    if (ImGui::BeginMenuBar()) {
        std::string_view last;
        for (const Command& command : commands())
            if (command.menu != std::exchange(last, command.menu)) draw_menu(state, command.menu);
        end = ImGui::GetCursorPosX();
        ImGui::EndMenuBar();
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    const float search = draw_command_search(state);
    draw_title(state, end + 8, search);
}

void draw_toolbar(State& state) {
    constexpr Tool left[] = {{"undo", ""}, {"redo", ""}};
    constexpr Tool edits[] = {{"add-node", "Add node", true},
                              {"align-left", "Align"},
                              {"tidy", "Tidy"},
                              {"mute", "Mute"},
                              {"preview-node", "Preview node"},
                              {"delete", "Delete"}};
    constexpr Tool looks[] = {{"find", "Find in graph"}, {"fit", "Show all"}, {"save", "Save"}};
    constexpr Tool right[] = {{"export-glsl", "Export GLSL...", true},
                              {"bake", "Bake maps...", true, true}};
    const float whole = ImGui::GetWindowSize().x;
    const bool words = whole >= wordless;
    for (const Tool& tool : left)
        draw_tool(state, tool, words);
    draw_divider();
    for (const Tool& tool : edits)
        draw_tool(state, tool, words);
    draw_divider();
    for (const Tool& tool : looks)
        draw_tool(state, tool, words);
    float x = whole - 8;
    for (const Tool& tool : right)
        x -= width_of(state, tool, words) + 8;
    ImGui::SetCursorPosX(std::max(x, ImGui::GetCursorPosX()));
    for (const Tool& tool : right)
        draw_tool(state, tool, words);
    ImGui::NewLine();
    const ImVec2 low = ImGui::GetWindowPos(), end = low + ImGui::GetWindowSize();
    ImGui::GetWindowDrawList()->AddLine({low.x, end.y - 1}, {end.x, end.y - 1}, theme::border);
}

}  // namespace wrinkle::editor
