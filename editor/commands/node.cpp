#include "editor/canvas/layout.h"
#include "editor/commands/groups.h"
#include "editor/document/edits.h"
#include "editor/panels/popups.h"

namespace wrinkle::editor {
namespace {

void add_node(State& state) {
    open_palette(state, pointed_at(state.view), {});
    state.palette.at_selection = true;
}

void tidy(State& state) {
    state.view.surface_at.reset();
    state.view.outputs_at.reset();
    state.commit("Tidy", tidied(state));
    state.view.fitted = false;
}

std::string_view no_values(const State& state) {
    if (state.view.selected.size() != 1) return "Select one node.";
    const Card* card = state.layout.find(*state.view.selected.begin());
    return card && !card->fields.empty() ? "" : "The node has no values.";
}

constexpr Command table[] = {
    {"add-node", "Add node", "Space", "Node", always, add_node},
    {"add-picture", "Add picture", "I", "Node", always, choose_picture},
    {"edit-values", "Edit values", "Enter", "Node", no_values, edit_values},
    {"mute", "Mute", "M", "Node", wants_selection, mute_selected},
    {"swap-inputs", "Swap inputs", "Alt+S", "Node", wants_selection, swap_selected},
    {"tidy", "Tidy", "Ctrl+L", "Node", always, tidy},
};

}  // namespace

std::span<const Command> node_commands() {
    return table;
}

}  // namespace wrinkle::editor
