#include "editor/view/canvas/arrange.h"

#include <algorithm>
#include <cmath>

#include "editor/view/canvas/columns.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

std::vector<const Card*> selected_cards(const State& state) {
    std::vector<const Card*> cards;
    for (const Card& card : state.layout.cards)
        if (card.kind == Card::Kind::node && state.view.selected.contains(card.id))
            cards.push_back(&card);
    return cards;
}

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
    std::sort(cards.begin(), cards.end(),
              [&](const Card* a, const Card* b) { return start(*a) < start(*b); });
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

}  // namespace wrinkle::editor
