#include <algorithm>

#include "editor/model/document/levels.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/groups.h"
#include "editor/view/edit/edits.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

void add_node(State& state) {
    open_palette(state, pointed_at(state.view), {});
    state.palette.at_selection = true;
}

void tidy(State& state) {
    Tidied tidy = tidied(state);
    const uint64_t before = state.history.serial();
    state.commit("Tidy", std::move(tidy.document));
    if (state.history.serial() != before) push_borders(state, tidy.borders);
    state.view.fitted = false;
}

std::string_view no_outer(const State& state) {
    return state.parent_graphs.empty() ? "This graph was not opened from another." : "";
}
std::string_view no_group(const State& state) {
    return selected_group(state) ? "" : "Select one node that is a sub-graph.";
}

// Return to the parent graph, or to the outermost graph.
void leave_group(State& state) {
    request_action(state, {PendingAction::Kind::leave, {}, state.parent_graphs.size() - 1});
}
void leave_groups(State& state) {
    request_action(state, {PendingAction::Kind::leave, {}, 0});
}
std::string_view wants_two(const State& state) {
    return state.view.selected.size() < 2 ? "Fewer than two nodes are selected." : "";
}
std::string_view wants_three(const State& state) {
    return state.view.selected.size() < 3 ? "Fewer than three nodes are selected." : "";
}
std::string_view no_values(const State& state) {
    if (state.view.selected.size() != 1) return "Select one node.";
    if (selected_group(state)) return {};
    const Card* card = state.layout.find(*state.view.selected.begin());
    return card && !card->fields.empty() ? "" : "The node has no values.";
}

// Shows the node previews of the selected nodes, or hides them if all are shown.
void turn_pictures(State& state) {
    View& view = state.view;
    view.node_previews = true;
    bool all = true;
    for (const std::string& id : view.selected) {
        const Card* card = state.layout.find(id);
        all = all && (!card || !card->type || card->preview_y >= 0);
    }
    for (const std::string& id : view.selected) {
        const Card* card = state.layout.find(id);
        if (!card || (card->preview_y >= 0) != all) continue;
        if (view.turned.erase(id) == 0) view.turned.insert(id);
    }
    state.layout_stale = true;
}

std::string_view no_folded(const State& state) {
    if (state.view.selected.empty()) return wants_selection(state);
    const auto cards = selected_cards(state);
    const bool any =
        std::ranges::any_of(cards, [](const Card* card) { return !card->more.empty(); });
    return any ? "" : "Every port of the selected nodes is shown.";
}

// Shows all ports of the selected nodes, or folds them if all are shown.
void turn_ports(State& state) {
    std::set<std::string> folded, unfolded;
    for (const Card* card : selected_cards(state))
        if (!card->more.empty()) (card->unfolded ? unfolded : folded).insert(card->id);
    if (folded.empty())
        for (const std::string& id : unfolded)
            state.view.unfolded.erase(id);
    state.view.unfolded.merge(folded);
    state.layout_stale = true;
}

template <Side Where>
void align(State& state) {
    state.commit("Align", aligned(state, Where));
}
template <bool Across>
void distribute(State& state) {
    state.commit("Distribute", distributed(state, Across));
}

constexpr Command node_table[] = {
    {"add-node", "Add node", "Space", always, add_node},
    {"add-picture", "Add image", "I", always, choose_image},
    {"edit-values", "Edit values, or open the sub-graph", "Enter", no_values,
     [](State& s) { selected_group(s) ? open_selected_group(s) : edit_values(s); }},
    {"expose", "Expose as an input of the graph", "E", no_exposable, expose_pointed},
    {"copy-value", "Copy the value to the selected nodes", "Shift+Enter", no_copied_value,
     copy_pointed_value},
    {"context-menu", "Menu of the selected node", "Shift+F10", wants_selection,
     open_selection_menu},
    {"mute", "Mute", "M", wants_selection, mute_selected},
    {"picture", "Thumbnail", "V", wants_selection, turn_pictures},
    {"ports", "All ports of a long card", "U", no_folded, turn_ports},
    {"swap-inputs", "Swap inputs", "Alt+S", wants_selection, swap_selected},
    {"frame", "Frame", "C", always, frame_selected},
    {"note", "Note", "N", always, add_note},
    {"group", "Group", "Ctrl+G", wants_selection, group_selected},
    {"ungroup", "Ungroup", "Ctrl+Shift+G", wants_selection, ungroup_selected},
    {"open-group", "Open sub-graph", "Tab", no_group, open_selected_group},
    {"leave-group", "Back to the graph around it", "Shift+Tab", no_outer, leave_group},
    {"leave-groups", "Back to the outermost graph", "", no_outer, leave_groups},
    {"tidy", "Tidy", "Ctrl+L", always, tidy},
    {"tidy-selection", "Tidy selection", "Ctrl+Shift+L", wants_selection,
     [](State& s) { s.commit("Tidy selection", tidied_selection(s)); }},
    {"align-left", "Align left", "Alt+Left", wants_two, align<Side::left>},
    {"align-right", "Align right", "Alt+Right", wants_two, align<Side::right>},
    {"align-top", "Align top", "Alt+Up", wants_two, align<Side::top>},
    {"align-bottom", "Align bottom", "Alt+Down", wants_two, align<Side::bottom>},
    {"align-column", "Align middles in a column", "", wants_two, align<Side::middle_x>},
    {"align-row", "Align middles in a row", "", wants_two, align<Side::middle_y>},
    {"distribute-across", "Distribute across", "", wants_three, distribute<true>},
    {"distribute-down", "Distribute down", "", wants_three, distribute<false>},
    {"snap", "Snap to grid", "", wants_selection,
     [](State& s) { s.commit("Snap to grid", snapped(s)); }},
};

}  // namespace

const std::span<const Command> node_commands = node_table;

}  // namespace wrinkle::editor
