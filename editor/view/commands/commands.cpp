#include "editor/view/commands/commands.h"

#include "base/text.h"
#include "editor/view/commands/groups.h"
#include "editor/view/input/input_queue.h"

namespace wrinkle::editor {
namespace {

std::vector<Command> all_commands() {
    const std::pair<std::string_view, std::span<const Command>> menus[] = {
        {"File", file_commands}, {"Edit", edit_commands},       {"View", view_commands},
        {"Node", node_commands}, {"Preview", preview_commands}, {"Help", help_commands}};
    std::vector<Command> all;
    for (const auto& [menu, group] : menus)
        for (const Command& command : group)
            all.emplace_back(command).menu = menu;
    return all;
}

bool pressed(std::string_view keys) {
    const ImGuiIO& io = ImGui::GetIO();
    bool ctrl = false, shift = false, alt = false;
    int key = 0;
    for (const std::string_view part : split(keys, '+')) {
        ctrl |= part == "Ctrl";
        shift |= part == "Shift";
        alt |= part == "Alt";
        key = key_named(part);
    }
    return key != 0 && io.KeyCtrl == ctrl && io.KeyShift == shift && io.KeyAlt == alt &&
           ImGui::IsKeyPressed(key, false);
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> all = all_commands();
    return all;
}

const Command* find_command(std::string_view id) {
    for (const Command& command : commands())
        if (command.id == id) return &command;
    return nullptr;
}

bool run_command(State& state, std::string_view id) {
    const Command* command = find_command(id);
    if (!command || !command->enabled(state)) return false;
    command->run(state);
    return true;
}

bool has_open_dialog(const State& state) {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) || state.palette.open ||
           state.help.open || state.offer.open || state.box_text.open || state.context_menu.open ||
           state.question.open() || state.bake_dialog.open || state.host_dialog.open ||
           state.dropped.has_question() || state.browser.purpose != Browser::Purpose::none ||
           state.popup.kind != Popup::Kind::none;
}

void run_keys(State& state) {
    if (has_open_dialog(state) || state.gesture.kind != Gesture::Kind::none) return;
    for (const Command& command : commands())
        if (!command.keys.empty() && pressed(command.keys) && command.enabled(state))
            return command.run(state);
}

}  // namespace wrinkle::editor
