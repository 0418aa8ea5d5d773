#include "graph/edit.h"
#include "editor/model/document/wiring.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/commands/groups.h"
#include "editor/view/edit/clipboard.h"
#include "editor/view/edit/edits.h"

namespace wrinkle::editor {
namespace {

std::string_view no_undo(const State& state) {
    return state.history.can_undo() ? "" : "Nothing has been done yet.";
}
std::string_view no_redo(const State& state) {
    return state.history.can_redo() ? "" : "Nothing has been undone.";
}
std::string_view no_delete(const State& state) {
    return state.view.selected_wire || !state.view.boxes.empty() ? "" : wants_selection(state);
}

std::string_view no_part(const State& state) {
    return state.view.boxes.empty() ? wants_selection(state) : "";
}

void undo(State& state) {
    const std::string name = state.history.undo_name();
    undo_step(state);
    state.status = "Undid: " + name;
}

void redo(State& state) {
    const std::string name = state.history.redo_name();
    redo_step(state);
    state.status = "Redid: " + name;
}

std::string_view no_steps(const State& state) {
    return state.history.size() > 1 ? "" : "Nothing has been done yet.";
}

// Lists the steps with the current one chosen.
void list_steps(State& state) {
    open_list(state, Palette::List::steps);
    state.palette.chosen = static_cast<int>(state.history.size() - 1 - state.history.at());
    state.palette.first = state.palette.chosen;
}

void select_all(State& state) {
    for (const NodePtr& node : state.document().nodes)
        state.view.selected.insert(node->id);
    const std::vector<BoxId> boxes = all_boxes(state.document());
    state.view.boxes = {boxes.begin(), boxes.end()};
}

template <Direction Where>
void select_reachable(State& state) {
    state.view.selected = reachable(state.document(), state.view.selected, Where);
}

constexpr Command edit_table[] = {
    {"undo", "Undo", "Ctrl+Z", no_undo, undo},
    {"redo", "Redo", "Ctrl+Shift+Z", no_redo, redo},
    {"history", "Undo history", "Ctrl+H", no_steps, list_steps},
    {"delete", "Delete", "Delete", no_delete, delete_selected},
    {"delete-with-wires", "Delete with wires", "Shift+Delete", no_delete,
     delete_selected_with_wires},
    {"cut", "Cut", "Ctrl+X", no_part, cut_selected},
    {"copy", "Copy", "Ctrl+C", no_part, copy_selected},
    {"paste", "Paste", "Ctrl+V", always, paste},
    {"duplicate", "Duplicate", "Ctrl+D", no_part, [](State& s) { duplicate_selected(s); }},
    {"duplicate-alone", "Duplicate without inputs", "Ctrl+Shift+D", no_part,
     [](State& s) { duplicate_selected(s, false); }},
    {"find", "Find in graph", "Ctrl+F", always,
     [](State& s) { open_list(s, Palette::List::nodes); }},
    {"select-all", "Select all", "Ctrl+A", always, select_all},
    {"select-upstream", "Select what feeds it", "L", wants_selection,
     select_reachable<Direction::upstream>},
    {"select-downstream", "Select what it feeds", "Shift+L", wants_selection,
     select_reachable<Direction::downstream>},
};

}  // namespace

const std::span<const Command> edit_commands = edit_table;

}  // namespace wrinkle::editor
