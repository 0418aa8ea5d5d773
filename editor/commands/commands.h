// Everything that can be done by name, in one table: menus, keys, the command palette, the list of
// shortcuts and scripts read it. A command stands in the file of its menu in this folder.
#pragma once

#include <span>
#include <string_view>

#include "editor/state.h"

namespace wrinkle::editor {

struct Command {
    std::string_view id;     // "undo"
    std::string_view title;  // "Undo"
    std::string_view keys;   // "Ctrl+Z"; "" for none
    std::string_view menu;   // "Edit"
    // Why it cannot be run now, a short sentence; "" when it can.
    std::string_view (*why_not)(const State&);
    void (*run)(State&);
    bool (*on)(const State&) = nullptr;  // of a switch: whether it is on

    bool enabled(const State& state) const { return why_not(state).empty(); }
};

std::span<const Command> commands();
const Command* find_command(std::string_view id);
bool run_command(State& state, std::string_view id);  // false when unknown or not enabled

// Runs what the keys of this frame ask for, unless a text has the keyboard.
void run_keys(State& state);

}  // namespace wrinkle::editor
