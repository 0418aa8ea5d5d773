// Parts of the command table, one per menu, in the order of the menu bar; and common functions for
// Command::why_not.
#pragma once

#include "editor/view/commands/commands.h"

namespace wrinkle::editor {

std::span<const Command> file_commands();
std::span<const Command> edit_commands();
std::span<const Command> view_commands();
std::span<const Command> node_commands();
std::span<const Command> preview_commands();
std::span<const Command> help_commands();

inline std::string_view always(const State&) {
    return {};
}
inline std::string_view wants_selection(const State& state) {
    return state.view.selected.empty() ? "Nothing is selected." : "";
}

}  // namespace wrinkle::editor
