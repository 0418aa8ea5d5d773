#include "editor/view/canvas/arrange.h"

#include <algorithm>
#include <cmath>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/columns.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr float gap = 40, touch = 8;

bool overlaps(const Card& a, const Card& b) {
    return a.at.x < b.at.x + b.size.x + touch && b.at.x < a.at.x + a.size.x + touch &&
           a.at.y < b.at.y + b.size.y + touch && b.at.y < a.at.y + a.size.y + touch;
}

struct Moved {
    std::set<std::string> nodes;
    float by = 0;
};

void put_borders(CanvasState& canvas, const View::Borders& at) {
    canvas.view.surface_at = at.surface;
    canvas.view.outputs_at = at.outputs;
    canvas.layout_stale = true;
}

}  // namespace

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
    right.nodes = with_downstream(document, right.nodes);
    left.nodes = with_upstream(document, left.nodes);
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

void push_borders(State& state, const View::Borders& to) {
    View& view = state.view;
    view.pushes.push_back({state.history.serial(), {view.surface_at, view.outputs_at}, to});
    put_borders(state, to);
}

void follow_undo(CanvasState& canvas, uint64_t serial) {
    for (const View::Push& push : canvas.view.pushes)
        if (push.serial == serial) put_borders(canvas, push.from);
}

void follow_redo(CanvasState& canvas, uint64_t serial) {
    for (const View::Push& push : canvas.view.pushes)
        if (push.serial == serial) put_borders(canvas, push.to);
}

}  // namespace wrinkle::editor
