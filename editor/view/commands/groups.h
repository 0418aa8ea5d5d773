// Parts of the command table, one per menu; and common functions for Command::why_not.
#pragma once

#include "editor/view/commands/commands.h"

namespace wrinkle::editor {

extern const std::span<const Command> file_commands, edit_commands, view_commands, node_commands,
    preview_commands, help_commands;

inline std::string_view always(const State&) {
    return {};
}
inline std::string_view wants_selection(const State& state) {
    return state.view.selected.empty() ? "Nothing is selected." : "";
}

}  // namespace wrinkle::editor
