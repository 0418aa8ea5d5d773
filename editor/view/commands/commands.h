// Table of all commands, used by menus, keyboard shortcuts, the command palette and the list of
// shortcuts. Each command is defined in the file of its menu in this folder.
#pragma once

#include <span>
#include <string_view>

#include "editor/view/state.h"

namespace wrinkle::editor {

struct Command {
    std::string_view id;     // "undo"
    std::string_view title;  // "Undo"
    std::string_view keys;   // "Ctrl+Z"; "" for none
    // Returns the reason why it cannot be run now, a short sentence; "" if it can.
    std::string_view (*why_not)(const State&);
    void (*run)(State&);
    bool (*on)(const State&) = nullptr;  // toggle: returns true if on
    std::string_view menu = {};          // "Edit", set for commands()

    bool enabled(const State& state) const { return why_not(state).empty(); }
};

std::span<const Command> commands();  // in the order of the menus
const Command* find_command(std::string_view id);
bool run_command(State& state, std::string_view id);  // false if unknown or disabled

// Returns true if a dialog, a popup or a search is open: it takes the keys.
bool has_open_dialog(const State& state);
// Runs the first enabled command with its keys pressed in this frame, unless a dialog is open or a
// gesture is in progress.
void run_keys(State& state);

}  // namespace wrinkle::editor
