#include "editor/commands/groups.h"
#include "editor/document/edits.h"

namespace wrinkle::editor {
namespace {

std::string_view no_undo(const State& state) {
    return state.history.can_undo() ? "" : "Nothing has been done yet.";
}
std::string_view no_redo(const State& state) {
    return state.history.can_redo() ? "" : "Nothing has been undone.";
}
std::string_view no_delete(const State& state) {
    return state.view.selected_wire ? "" : wants_selection(state);
}

void undo(State& state) {
    const std::string name = state.history.undo_name();
    state.history.undo();
    state.status = "Undid: " + name;
}

void redo(State& state) {
    const std::string name = state.history.redo_name();
    state.history.redo();
    state.status = "Redid: " + name;
}

void select_all(State& state) {
    for (const NodePtr& node : state.document().nodes)
        state.view.selected.insert(node->id);
}

constexpr Command table[] = {
    {"undo", "Undo", "Ctrl+Z", "Edit", no_undo, undo},
    {"redo", "Redo", "Ctrl+Shift+Z", "Edit", no_redo, redo},
    {"delete", "Delete", "Delete", "Edit", no_delete, delete_selected},
    {"duplicate", "Duplicate", "Ctrl+D", "Edit", wants_selection, duplicate_selected},
    {"select-all", "Select all", "Ctrl+A", "Edit", always, select_all},
};

}  // namespace

std::span<const Command> edit_commands() {
    return table;
}

}  // namespace wrinkle::editor
