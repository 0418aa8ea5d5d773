#include "editor/view/canvas/arrange.h"

#include <algorithm>
#include <cmath>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/columns.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

ImVec2 in_line(const Card& card, const Extent& box, Side side) {
    ImVec2 at = card.at;
    if (side == Side::left) at.x = box.low.x;
    if (side == Side::right) at.x = box.high.x - card.size.x;
    if (side == Side::middle_x) at.x = std::round((box.low.x + box.high.x - card.size.x) / 2);
    if (side == Side::top) at.y = box.low.y;
    if (side == Side::bottom) at.y = box.high.y - card.size.y;
    if (side == Side::middle_y) at.y = std::round((box.low.y + box.high.y - card.size.y) / 2);
    return at;
}

constexpr float gap = 40, touch = 8;

bool overlaps(const Card& a, const Card& b) {
    return a.at.x < b.at.x + b.size.x + touch && b.at.x < a.at.x + a.size.x + touch &&
           a.at.y < b.at.y + b.size.y + touch && b.at.y < a.at.y + a.size.y + touch;
}

struct Moved {
    std::set<std::string> nodes;
    float by = 0;
};

void put_borders(CanvasState& canvas, const Borders& at) {
    static_cast<Borders&>(canvas.view) = at;
    canvas.layout_stale = true;
}

}  // namespace

Document aligned(const State& state, Side side) {
    const std::vector<const Card*> cards = selected_cards(state);
    Extent box;
    for (const Card* card : cards)
        box.add(card->extent());
    std::vector<NodePosition> places;
    for (const Card* card : cards) {
        const ImVec2 at = in_line(*card, box, side);
        places.push_back({card->id, at.x, at.y});
    }
    return move_nodes(state.document(), places);
}

Document distributed(const State& state, bool across) {
    std::vector<const Card*> cards = selected_cards(state);
    if (cards.size() < 3) return state.document();
    const auto start = [&](const Card& card) { return across ? card.at.x : card.at.y; };
    const auto length = [&](const Card& card) { return across ? card.size.x : card.size.y; };
    std::ranges::sort(cards, {}, [&](const Card* card) { return start(*card); });
    float used = 0;
    for (const Card* card : cards)
        used += length(*card);
    const float span = start(*cards.back()) + length(*cards.back()) - start(*cards.front());
    const float gap = (span - used) / static_cast<float>(cards.size() - 1);
    std::vector<NodePosition> places;
    float next = start(*cards.front());
    for (const Card* card : cards) {
        const float at = std::round(next);
        places.push_back({card->id, across ? at : card->at.x, across ? card->at.y : at});
        next += length(*card) + gap;
    }
    return move_nodes(state.document(), places);
}

Document snapped(const State& state) {
    std::vector<NodePosition> places;
    for (const Card* card : selected_cards(state))
        places.push_back(
            {card->id, std::round(card->at.x / grid) * grid, std::round(card->at.y / grid) * grid});
    return move_nodes(state.document(), places);
}

Document make_space(const State& state, const Document& document, const Card& card,
                    std::optional<ImVec2>& outputs_at) {
    Moved right, left;
    for (const Card& other : state.layout.cards) {
        const bool is_outputs = other.kind == Card::Kind::outputs;
        if (other.id == card.id || !overlaps(card, other)) continue;
        if (other.kind != Card::Kind::node && !is_outputs) continue;
        const bool is_right =
            is_outputs || other.at.x + other.size.x / 2 >= card.at.x + card.size.x / 2;
        Moved& side = is_right ? right : left;
        side.by = std::max(side.by, is_right ? card.at.x + card.size.x + gap - other.at.x
                                             : other.at.x + other.size.x + gap - card.at.x);
        if (!is_outputs) side.nodes.insert(other.id);
    }
    right.nodes = reachable(document, right.nodes, Direction::downstream);
    left.nodes = reachable(document, left.nodes, Direction::upstream);
    const ImVec2 to_right(grid_up(right.by), 0), to_left(grid_up(left.by), 0);
    std::vector<NodePosition> places;
    for (const Card& other : state.layout.cards) {
        if (other.id == card.id) continue;
        const bool beyond = overlaps(card, other) || other.at.x >= card.at.x + card.size.x;
        if (other.kind == Card::Kind::outputs && right.by > 0 && beyond)
            outputs_at = other.at + to_right;
        if (other.kind != Card::Kind::node) continue;
        const bool goes_right = right.nodes.contains(other.id);
        if (!goes_right && !left.nodes.contains(other.id)) continue;
        const ImVec2 at = goes_right ? other.at + to_right : other.at - to_left;
        places.push_back({other.id, at.x, at.y});
    }
    return move_nodes(document, places);
}

void push_borders(State& state, const Borders& to) {
    state.view.pushes.push_back({state.history.serial(), state.view, to});
    put_borders(state, to);
}

void follow_step(CanvasState& canvas, uint64_t serial, bool undone) {
    for (const View::Push& push : canvas.view.pushes)
        if (push.serial == serial) put_borders(canvas, undone ? push.from : push.to);
}

}  // namespace wrinkle::editor
