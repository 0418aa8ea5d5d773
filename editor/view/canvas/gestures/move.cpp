#include "editor/view/canvas/gestures/gestures.h"

#include <cmath>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/refresh.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// Returns the only moving card if it has no wires; else nullptr.
const Card* loose_card(const State& state) {
    if (!state.gesture.carried_boxes.empty()) return nullptr;
    const Card* found = nullptr;
    for (const Card& card : state.layout.cards) {
        if (!state.gesture.carried.contains(card.id)) continue;
        if (found || card.kind != Card::Kind::node || !card.type) return nullptr;
        found = &card;
    }
    return found && is_unconnected(state.document(), found->id) ? found : nullptr;
}

std::optional<Passage> passage_in(const State& state, const Card& card, const Wire& wire) {
    if (!wire.known) return std::nullopt;
    if (card.reroute) return Passage{"in", "out"};
    return passage(*card.type, wire.from_type, wanted_at(state.model, wire.node, wire.port));
}

// Returns the wire into which the moved card would be inserted.
std::optional<size_t> wire_for_drop(const State& state) {
    const Card* card = loose_card(state);
    const auto wire = card ? wire_under(state.layout, *card) : std::nullopt;
    if (!wire || !passage_in(state, *card, state.layout.wires[*wire])) return std::nullopt;
    return wire;
}

bool drop_in_wire(State& state, const Document& moved) {
    const auto index = wire_for_drop(state);
    if (!index) return false;
    const Card card = *loose_card(state);
    const Wire wire = state.layout.wires[*index];
    const Connection place{wire.from, wire.node, wire.port};
    const Document wired = insert_in_wire(moved, place, card.id, *passage_in(state, card, wire));
    std::optional<ImVec2> outputs_at;
    state.commit("Insert " + card.id + " in a wire", make_space(state, wired, card, outputs_at));
    if (outputs_at) push_borders(state, {state.view.surface_at, outputs_at});
    return true;
}

}  // namespace

void begin_move(State& state, const std::string& id) {
    select_card(state, id);
    begin_gesture(state, Gesture::Kind::move);
    state.gesture.node = id;
    carry_selection(state);
}

void carry_selection(State& state) {
    Gesture& g = state.gesture;
    g.carried = state.view.selected;
    for (const BoxId& box : state.view.boxes)
        add_contents(state, box, g.carried, g.carried_boxes);
}

void drag_move(State& state, ImVec2 delta) {
    const ImVec2 by = delta * (1 / state.view.zoom);
    state.gesture.offset = {std::round(by.x / 8) * 8, std::round(by.y / 8) * 8};
    state.gesture.under_wire = wire_for_drop(state);
}

void drop_cards(State& state) {
    const ImVec2 by = state.gesture.offset;
    refresh(state);  // updates card positions to the last motion
    std::vector<NodePosition> places;
    for (const Card& card : state.layout.cards) {
        const bool carried = state.gesture.carried.contains(card.id);
        // The automatic layout would move cards without a position once others have one.
        const bool settles =
            card.kind == Card::Kind::node && !state.document().positions.find(card.id);
        if (!carried && !settles) continue;
        if (card.kind == Card::Kind::node) places.push_back({card.id, card.at.x, card.at.y});
        if (card.kind == Card::Kind::surface) state.view.surface_at = card.at;
        if (card.kind == Card::Kind::outputs) state.view.outputs_at = card.at;
    }
    if (by.x == 0 && by.y == 0) return;
    Document moved = move_nodes(state.document(), places);
    for (const BoxId& id : state.gesture.carried_boxes) {
        Box box = *find_box(state.document(), id);
        box.rect.x += by.x;
        box.rect.y += by.y;
        moved = with_box(moved, id.note, std::move(box));
    }
    if (!drop_in_wire(state, moved)) state.commit("Move", moved);
}

}  // namespace wrinkle::editor
