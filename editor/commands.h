// Everything that can be done by name, in one table: menus, keys, the command palette and scripts
// read it.
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
    bool (*enabled)(const State&);
    void (*run)(State&);
};

std::span<const Command> commands();
const Command* find_command(std::string_view id);
bool run_command(State& state, std::string_view id);  // false when unknown or not enabled

// Runs what the keys of this frame ask for, unless a text has the keyboard.
void run_keys(State& state);

}  // namespace wrinkle::editor
