#include "editor/view/edit/edits.h"

#include "base/file.h"
#include "editor/model/document/folders.h"
#include "editor/model/document/group.h"
#include "editor/model/document/levels.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

std::string free_file(const fs::path& folder) {
    std::error_code ignored;
    std::string name = "group.json";
    for (size_t n = 2; fs::exists(folder / name, ignored); ++n)
        name = "group" + std::to_string(n) + ".json";
    return name;
}

ImVec2 middle_of(const State& state) {
    ImVec2 sum(0, 0);
    float count = 0;
    for (const Card& card : state.layout.cards)
        if (card.kind == Card::Kind::node && state.view.selected.contains(card.id)) {
            sum = sum + card.at;
            ++count;
        }
    return count > 0 ? sum * (1 / count) : sum;
}

}  // namespace

const Node* selected_node(const State& state) {
    return state.view.selected.size() == 1 ? state.document().find(*state.view.selected.begin())
                                           : nullptr;
}

const Node* selected_group(const State& state) {
    const Node* node = selected_node(state);
    return node && node->subgraph() ? node : nullptr;
}

void open_selected_group(State& state) {
    if (const Node* node = selected_group(state))
        open_group(state, *node);
    else
        state.status = "Select one node that is a sub-graph.";
}

void group_selected(State& state) {
    if (state.path.empty()) {
        state.status = "Save the graph first; the group stands in a file beside it.";
        return;
    }
    const std::string file = free_file(state.folder());
    std::string why;
    const auto group = make_group(state.model, state.document(), state.view.selected, file, why);
    if (!group) {
        state.status = why;
        return;
    }
    if (!write_file(state.folder() / file, canonical_text(group->inner), why)) {
        state.status = file + " was not written: " + disk_words(why) + ".";
        return;
    }
    // The type of the new file's node is known only with the next model; the card without it has
    // the same width.
    const ImVec2 at = free_place(state, middle_of(state), *group->outer.find(group->node), nullptr,
                                 state.view.selected);
    state.commit("Group in " + file,
                 settled(state, move_node(group->outer, group->node, at.x, at.y)));
    show_new(state, {group->node});
}

}  // namespace wrinkle::editor
