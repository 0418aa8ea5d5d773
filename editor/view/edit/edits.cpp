#include "editor/view/edit/edits.h"

#include <cmath>

#include "editor/model/document/copies.h"
#include "editor/model/document/field.h"
#include "editor/model/document/wiring.h"
#include "editor/model/words.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
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
    state.commit(count > 0 ? "Delete " + counted(count, "node") : "Delete frame",
                 std::move(document));
    state.view.selected.clear();
    state.view.boxes.clear();
}

// Adds a box with its corners moved out to the grid, selects it and opens its text.
void commit_new(State& state, bool note, const Extent& extent, const char* text, const char* name) {
    const auto down = [](float at) { return std::floor(static_cast<double>(at) / 8) * 8; };
    const auto up = [](float at) { return std::ceil(static_cast<double>(at) / 8) * 8; };
    const double x = down(extent.low.x), y = down(extent.low.y);
    Box box;
    box.id = free_box_id(state.document(), note);
    box.text = text;
    box.rect = {x, y, up(extent.high.x) - x, up(extent.high.y) - y};
    const BoxId id{note, box.id};
    const std::string merge = "box " + std::to_string(state.history.serial());
    state.commit(name, with_box(state.document(), note, std::move(box)), merge);
    state.view.boxes = {id};
    edit_box_text(state, id);
    state.box_text.merge = merge;
}

Palette opened_at(ImVec2 at) {
    Palette palette;
    palette.open = palette.opening = true;
    palette.at = at;
    return palette;
}

}  // namespace

void mute_selected(State& state) {
    const Document& document = state.document();
    bool any_loud = false;
    for (const std::string& id : state.view.selected)
        if (const Node* node = document.find(id)) any_loud |= !node->muted;
    state.commit(any_loud ? "Mute" : "Unmute", mute_nodes(document, state.view.selected, any_loud));
}

Connection connection_at(const Gesture& wire, const Card& card, const Pin& pin) {
    if (wire.from_output) return {wire.from, card.link_id(), pin.port};
    return {{card.id, pin.port}, wire.node, wire.port};
}

void commit_connection(State& state, const Connection& to, const std::string& merge) {
    state.commit("Connect " + to.from.text() + " to " + (to.node.empty() ? "output" : to.node) +
                     "." + to.port,
                 with_wire(state.document(), to.from, to.node, to.port), merge);
}

std::string why_not(const State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    if (pin.output == wire.from_output)
        return pin.output ? "a wire ends at an input" : "a wire begins at an output";
    const auto [from, to, port] = connection_at(wire, card, pin);
    const std::string& loose = wire.from_output ? to : from.node;
    if (!to.empty() && wire.loops.contains(loose))
        return from.text() + " depends on " + to + ": that would be a loop";
    return wire_problem(state.model, state.document(), from, to, port);
}

void find_loops(const Document& document, Gesture& wire) {
    wire.loops = wire.from_output ? reachable(document, {wire.from.node}, Direction::upstream)
                                  : reachable(document, {wire.node}, Direction::downstream);
}

void open_palette(State& state, ImVec2 at, const Gesture& wire) {
    Palette& palette = state.palette;
    palette = opened_at(at);
    palette.wire = wire;
    palette.graphs = graph_files(state.folder());
    std::erase(palette.graphs, state.path.filename().string());
    palette.library = library_entries(state.keeping.folders);
}

void open_list(State& state, Palette::List list) {
    const View& view = state.view;
    const ImVec2 at(view.corner.x + view.extent.x / 2 - 144, view.corner.y + 64);
    state.palette = opened_at(at);
    state.palette.list = list;
}

void undo_step(State& state) {
    const uint64_t serial = state.history.serial();
    state.history.undo();
    follow_step(state, serial, true);
}

void redo_step(State& state) {
    state.history.redo();
    follow_step(state, state.history.serial(), false);
}

void go_to_step(State& state, size_t step) {
    while (state.history.at() > step)
        undo_step(state);
    while (state.history.at() < step && state.history.can_redo())
        redo_step(state);
}

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
    state.commit(fresh.empty() ? "Duplicate frame" : "Duplicate " + counted(fresh.size(), "node"),
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

void frame_selected(State& state) {
    const ImVec2 pointer = to_canvas(state.view, pointed_at(state.view));
    Extent cards;
    for (const Card& card : state.layout.cards)
        if (state.view.selected.contains(card.id)) cards.add(card.extent());
    const Extent extent = cards.empty() ? Extent{pointer, pointer + ImVec2(320, 200)}
                                        : Extent{cards.low - ImVec2(24, 24 + title_height),
                                                 cards.high + ImVec2(24, 24)};
    commit_new(state, false, extent, "Frame", "Frame");
}

void add_note(State& state) {
    const ImVec2 at = to_canvas(state.view, pointed_at(state.view));
    commit_new(state, true, {at, at + ImVec2(240, 96)}, "", "Note");
}

void edit_box_text(State& state, const BoxId& id) {
    const Box* box = find_box(state.document(), id);
    if (!box) return;
    state.box_text = {true, true, id, box->text, ""};
}

void accept_box_text(State& state) {
    const BoxText entry = std::move(state.box_text);
    state.box_text = {};
    const Box* found = find_box(state.document(), entry.box);
    if (!found) return;
    Box box = *found;
    box.text = entry.text;
    state.commit(entry.box.note ? "Write note" : "Name frame",
                 with_box(state.document(), entry.box.note, std::move(box)), entry.merge);
}

}  // namespace wrinkle::editor
