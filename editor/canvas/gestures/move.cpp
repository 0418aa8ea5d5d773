#include "editor/canvas/gestures/gestures.h"

#include <cmath>

#include "editor/canvas/layout.h"
#include "editor/document/refresh.h"
#include "editor/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {

void drag_move(State& state, ImVec2 delta) {
    const ImVec2 by = delta * (1 / state.view.zoom);
    state.gesture.offset = {std::round(by.x / 8) * 8, std::round(by.y / 8) * 8};
}

void drop_cards(State& state) {
    const ImVec2 by = state.gesture.offset;
    refresh(state);  // the cards stand where the last motion has put them
    std::vector<NodePosition> places;
    for (const Card& card : state.layout.cards) {
        if (!state.view.selected.contains(card.id)) continue;
        if (card.kind == Card::Kind::node) places.push_back({card.id, card.at.x, card.at.y});
        if (card.kind == Card::Kind::surface) state.view.surface_at = card.at;
        if (card.kind == Card::Kind::outputs) state.view.outputs_at = card.at;
    }
    if (by.x != 0 || by.y != 0) state.commit("Move", move_nodes(state.document(), places));
}

}  // namespace wrinkle::editor
