// Menu bar, toolbar and status bar.
#include <cstdio>

#include "editor/commands/commands.h"
#include "editor/look/draw.h"
#include "editor/look/theme.h"
#include "editor/panels/panels.h"
#include "editor/panels/questions.h"

namespace wrinkle::editor {
namespace {

void draw_menu(State& state, const char* menu) {
    const bool open = ImGui::BeginMenu(menu);
    name_item(state, std::string("menu:") + menu);
    if (!open) return;
    for (const Command& command : commands()) {
        if (command.menu != menu) continue;
        const bool enabled = command.enabled(state);
        const std::string title(command.title), keys(command.keys);
        const bool chosen =
            ImGui::MenuItem(title.c_str(), keys.c_str(), command.on && command.on(state), enabled);
        name_item(state, "menu:" + std::string(command.id));
        if (chosen) command.run(state);
    }
    if (std::string_view(menu) == "File") draw_recent_files(state);
    ImGui::EndMenu();
}

void command_button(State& state, const char* id) {
    const Command* command = find_command(id);
    const bool enabled = command->enabled(state);
    ImGui::BeginDisabled(!enabled);
    const std::string title(command->title);
    const bool pressed = button(state, title.c_str(), std::string("tool:") + id);
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered() && !command->keys.empty())
        ImGui::SetTooltip("%s  %s", title.c_str(), std::string(command->keys).c_str());
    if (pressed) command->run(state);
    ImGui::SameLine();
}

std::string compile_result(const State& state) {
    const Diagnostics& problems = state.built.problems;
    if (problems.has_errors() || !state.built.uniform)
        return counted(problems.error_count(), "error");
    char text[64];
    std::snprintf(text, sizeof text, "Compiled in %.1f ms", state.built.milliseconds);
    return text;
}

}  // namespace

void name_item(State& state, const std::string& target) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    state.targets.add(target, {low.x, low.y, high.x, high.y});
}

std::string counted(size_t number, const char* what) {
    return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
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

void draw_menu_bar(State& state) {
    ImGui::SetCursorPos({8, 2});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    ImGui::BeginChild("##bar", {0, 0}, false, ImGuiWindowFlags_MenuBar);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 8));
    if (ImGui::BeginMenuBar()) {
        for (const char* menu : {"File", "Edit", "View", "Node", "Preview"})
            draw_menu(state, menu);
        ImGui::EndMenuBar();
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
    const std::string file = state.file_name() + (state.dirty() ? ", edited" : "");
    const std::string& name = state.document().name;
    const Fonts& fonts = state.fonts;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float name_width = text_width(fonts.bold(16), 16, name);
    const float whole = name_width + 10 + text_width(fonts.regular(14), 14, file);
    const float x = ImGui::GetIO().DisplaySize.x / 2 - whole / 2;
    draw_text(list, fonts.bold(16), 16, {x, 6}, theme::text, name);
    draw_text(list, fonts.regular(14), 14, {x + name_width + 10, 7}, theme::text_dim, file);
}

void draw_toolbar(State& state) {
    for (const char* id :
         {"undo", "redo", "add-node", "tidy", "mute", "delete", "fit", "commands", "save"})
        command_button(state, id);
    ImGui::NewLine();
}

void draw_status_bar(State& state) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* font = state.fonts.regular(14);
    const ImVec2 size = ImGui::GetWindowSize();
    const ImVec2 at = ImGui::GetWindowPos() + ImVec2(12, 5);
    const bool failed = state.built.problems.has_errors() || !state.built.uniform;
    const std::string result = compile_result(state);
    draw_text(list, font, 14, at, failed ? theme::error : theme::ok, result);
    const float x = at.x + text_width(font, 14, result) + 24;
    char right[96];
    std::snprintf(right, sizeof right, "%s, %s  %.0f %%",
                  counted(state.document().nodes.size(), "node").c_str(),
                  counted(state.layout.wires.size(), "wire").c_str(),
                  static_cast<double>(state.view.zoom) * 100);
    const float right_width = text_width(font, 14, right);
    draw_text(list, font, 14, {size.x - 12 - right_width, at.y}, theme::text_dim, right);
    draw_text(list, font, 14, {x, at.y}, theme::text_dim,
              fitting(font, 14, state.status, size.x - right_width - x - 40));
}

}  // namespace wrinkle::editor
