// Edits of the selected nodes.
#include "editor/model/document/copies.h"
#include "editor/model/document/wiring.h"
#include "editor/model/words.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

using Remove = Document (*)(const Model&, const Document&, const std::set<std::string>&);

void remove_selected(State& state, Remove remove) {
    if (const auto wire = state.view.selected_wire) {
        state.commit("Delete wire",
                     cut_wires(state.model, state.document(), {{{}, wire->node, wire->port}}));
        state.view.selected_wire.reset();
        return;
    }
    Document document = remove(state.model, state.document(), state.view.selected);
    const size_t count = state.document().nodes.size() - document.nodes.size();
    for (const BoxId& box : state.view.boxes)
        document = without_box(document, box);
    state.commit(count > 0 ? "Delete " + nodes_in_words(count) : "Delete frame",
                 std::move(document));
    state.view.selected.clear();
    state.view.boxes.clear();
}

}  // namespace

void delete_selected(State& state) {
    remove_selected(state, delete_and_reconnect);
}

void delete_selected_with_wires(State& state) {
    remove_selected(state, delete_and_disconnect);
}

void duplicate_selected(State& state, bool with_inputs) {
    const std::set<std::string>& ids = state.view.selected;
    const Document source =
        with_inputs ? state.document() : without_outer_wires(state.model, state.document(), ids);
    Copies copies = copies_of(source, ids, state.document(), [](const Link&) { return true; });
    std::vector<Extent> from;
    std::vector<NodePosition> places;
    std::set<std::string> fresh;
    for (const Card& card : state.layout.cards) {
        const auto copy = copies.new_id.find(card.id);
        if (card.kind != Card::Kind::node || copy == copies.new_id.end()) continue;
        from.push_back({card.at, card.at + card.size});
        places.push_back({copy->second, card.at.x, card.at.y});
        fresh.insert(copy->second);
    }
    const std::set<BoxId> boxes = state.view.boxes;
    const ImVec2 by = free_offset(state, from, source, boxes, {32, 32});
    for (NodePosition& place : places)
        place.x += by.x, place.y += by.y;
    const BoxCopies boxed = with_boxes(add_nodes(state.document(), std::move(copies.nodes), places),
                                       source, boxes, by.x, by.y);
    state.commit(fresh.empty() ? "Duplicate frame" : "Duplicate " + nodes_in_words(fresh.size()),
                 settled(state, boxed.document));
    if (!fresh.empty() || !boxed.ids.empty()) show_new(state, fresh);
    state.view.boxes = boxed.ids;
}

void swap_selected(State& state) {
    Document document = state.document();
    for (const std::string& id : state.view.selected)
        document = swap_inputs(state.model, document, id);
    if (same_document(document, state.document()))
        state.status = "No selected node has two inputs of one type that differ.";
    state.commit("Swap inputs", std::move(document));
}

}  // namespace wrinkle::editor
