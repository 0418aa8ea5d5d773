#include "editor/view/canvas/gestures/gestures.h"

#include <algorithm>
#include <cmath>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/edit/layer.h"
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
    return passage(*card.type, wire.from_type,
                   wanted_ends(state.model, state.document(), wire.node, wire.port));
}

// Returns the wire into which the moved card would be inserted, or over which it would be laid.
std::optional<size_t> wire_for_drop(const State& state) {
    const Card* card = loose_card(state);
    const auto index = card ? wire_under(state.layout, *card) : std::nullopt;
    if (!index) return std::nullopt;
    const Wire& wire = state.layout.wires[*index];
    const Port* bump = card->reroute ? nullptr : bump_of(*card->type);
    const bool fits =
        passage_in(state, *card, wire) || (bump && takes_bump(state, wire, bump->type));
    return fits ? index : std::nullopt;
}

// Lays the bump of the card over the one on the wire. The card moves off the cards that it covers.
void lay_over(State& state, const Document& moved, const Card& card, const Wire& wire) {
    const ImVec2 at = free_place(state, moved, card.at, *moved.find(card.id), card.type, {card.id});
    const Document placed = move_node(moved, card.id, at.x, at.y);
    std::string why;
    const auto laid = with_bump_on_wire(state, placed, wire, {card.id, bump_of(*card.type)->name},
                                        at + ImVec2(card.size.x + 64, 0), why);
    if (laid)
        state.commit("Lay " + card.id + " over a bump", *laid);
    else
        state.status = why;
}

bool drop_in_wire(State& state, const Document& moved) {
    const auto index = wire_for_drop(state);
    if (!index) return false;
    const Card card = *loose_card(state);
    const Wire wire = state.layout.wires[*index];
    const auto through = passage_in(state, card, wire);
    if (!through) {
        lay_over(state, moved, card, wire);
        return true;
    }
    const Document wired = insert_in_wire(moved, wire, card.id, *through);
    std::optional<ImVec2> outputs_at;
    state.commit("Insert " + card.id + " in a wire", make_space(state, wired, card, outputs_at));
    if (outputs_at) push_borders(state, {state.view.surface_at, outputs_at});
    return true;
}

constexpr double min_width = 64, min_height = 40;

double on_grid(double length) {
    return std::round(length / 8) * 8;
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
    const Gesture& g = state.gesture;
    if (!g.moved) return g.node.empty() ? click_box(state, g.box) : click_card(state, g.node);
    const ImVec2 by = g.offset;
    refresh(state);  // updates card positions to the last motion
    std::vector<NodePosition> places;
    for (const Card& card : state.layout.cards) {
        if (!state.gesture.carried.contains(card.id)) continue;
        if (card.kind == Card::Kind::node) places.push_back({card.id, card.at.x, card.at.y});
        if (card.kind == Card::Kind::surface) state.view.surface_at = card.at;
        if (card.kind == Card::Kind::outputs) state.view.outputs_at = card.at;
    }
    if (by.x == 0 && by.y == 0) return;
    Document moved = move_nodes(settled(state, state.document()), places);
    for (const BoxId& id : state.gesture.carried_boxes) {
        Box box = *find_box(state.document(), id);
        box.rect.x += by.x;
        box.rect.y += by.y;
        moved = with_box(moved, id.note, std::move(box));
    }
    if (!drop_in_wire(state, moved)) state.commit("Move", moved);
}

void begin_box(State& state, const Hit& hit) {
    const BoxId id = all_boxes(state.document())[hit.part];
    select_box(state, id);
    begin_gesture(state, hit.edges != 0 ? Gesture::Kind::resize : Gesture::Kind::move);
    Gesture& g = state.gesture;
    g.box = id;
    g.edges = hit.edges;
    g.rect = find_box(state.document(), id)->rect;
    carry_selection(state);
    if (g.kind == Gesture::Kind::move) add_contents(state, id, g.carried, g.carried_boxes);
}

void drag_resize(State& state, ImVec2 delta) {
    const Gesture& g = state.gesture;
    const Box* found = find_box(state.document(), g.box);
    if (!found) return;
    Box box = *found;
    const double dx = delta.x / state.view.zoom, dy = delta.y / state.view.zoom;
    double left = g.rect.x, right = left + g.rect.width;
    double top = g.rect.y, bottom = top + g.rect.height;
    if (g.edges & 1) left = std::min(on_grid(left + dx), right - min_width);
    if (g.edges & 2) right = std::max(on_grid(right + dx), left + min_width);
    if (g.edges & 4) top = std::min(on_grid(top + dy), bottom - min_height);
    if (g.edges & 8) bottom = std::max(on_grid(bottom + dy), top + min_height);
    box.rect = {left, top, right - left, bottom - top};
    state.commit(g.box.note ? "Resize note" : "Resize frame",
                 with_box(state.document(), g.box.note, std::move(box)), g.merge);
}

}  // namespace wrinkle::editor
