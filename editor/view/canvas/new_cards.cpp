#include "editor/view/canvas/new_cards.h"
#include "editor/view/canvas/boxes.h"

#include "editor/model/document/boxes.h"

#include <algorithm>
#include <cmath>

#include "editor/view/canvas/columns.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/make_card.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr float clear = 16;  // between cards
constexpr float step = 2 * grid;
constexpr int most_steps = 128;
constexpr size_t max_things = 16;

bool is_free(const std::vector<Extent>& fixed, const std::vector<Extent>& moving, ImVec2 by) {
    return std::ranges::none_of(moving, [&](const Extent& thing) {
        const ImVec2 low = thing.low + by - ImVec2(clear, clear);
        const ImVec2 high = thing.high + by + ImVec2(clear, clear);
        return std::ranges::any_of(fixed, [&](const Extent& other) {
            return low.x < other.high.x && low.y < other.high.y && high.x > other.low.x &&
                   high.y > other.low.y;
        });
    });
}

// Returns the free offset nearest to `by` among those `ring` steps away along one axis.
std::optional<ImVec2> free_on_ring(const std::vector<Extent>& fixed,
                                   const std::vector<Extent>& moving, ImVec2 by, int ring) {
    const float far = static_cast<float>(ring) * step;
    for (int i = 0; i <= ring; ++i) {
        const float along = static_cast<float>(i) * step;
        const ImVec2 places[] = {{far, along},  {along, far},  {far, -along},  {-along, far},
                                 {-far, along}, {along, -far}, {-far, -along}, {-along, -far}};
        for (const ImVec2 place : places)
            if (is_free(fixed, moving, by + place)) return by + place;
    }
    return std::nullopt;
}

}  // namespace

Extent around(const std::vector<Extent>& things) {
    Extent all;
    for (const Extent& each : things)
        all.add(each);
    return all;
}

ImVec2 free_shift(const std::vector<Extent>& fixed, std::vector<Extent> moving, ImVec2 by) {
    by = {std::round(by.x / grid) * grid, std::round(by.y / grid) * grid};
    if (moving.empty() || fixed.empty()) return by;
    if (moving.size() > max_things) moving = {around(moving)};
    for (int ring = 0; ring <= most_steps; ++ring)
        if (const auto place = free_on_ring(fixed, moving, by, ring)) return *place;
    return {by.x, grid_up(around(fixed).high.y + clear - around(moving).low.y)};
}

std::vector<Extent> card_extents(const CanvasState& canvas, const std::set<std::string>& except) {
    std::vector<Extent> extents;
    for (const Card& card : canvas.layout.cards)
        if (!except.contains(card.id)) extents.push_back(card.extent());
    return extents;
}

ImVec2 free_offset(const State& state, const std::vector<Extent>& places, const Document& source,
                   const std::set<BoxId>& boxes, ImVec2 by) {
    std::vector<Extent> fixed = card_extents(state), moving = places;
    for (const BoxId& id : boxes)
        moving.push_back(extent_of(*find_box(source, id)));
    if (!boxes.empty())
        for (const BoxId& id : all_boxes(state.document()))
            fixed.push_back(extent_of(*find_box(state.document(), id)));
    return free_shift(fixed, std::move(moving), by);
}

ImVec2 new_card_size(const State& state, const Node& node, const NodeType* type) {
    return make_card(state.fonts, node, type, {}, shown_of(state.view, node, type)).size;
}

ImVec2 free_place(const State& state, const Document& document, ImVec2 at, const Node& node,
                  const NodeType* type, const std::set<std::string>& except) {
    std::vector<Extent> fixed = card_extents(state, except);
    for (const Position& position : document.positions) {
        const Node* other = document.find(position.id);
        if (!other || state.layout.find(position.id)) continue;
        const ImVec2 low(static_cast<float>(position.x), static_cast<float>(position.y));
        const NodeType* its_type = state.registry->find(other->type);
        fixed.push_back({low, low + new_card_size(state, *other, its_type)});
    }
    return free_shift(fixed, {{{0, 0}, new_card_size(state, node, type)}}, at);
}

Document settled(const State& state, const Document& document) {
    std::vector<NodePosition> places;
    for (const Card& card : state.layout.cards)
        if (card.kind == Card::Kind::node && document.find(card.id) &&
            !document.positions.find(card.id))
            places.push_back({card.id, card.at.x, card.at.y});
    return places.empty() ? document : move_nodes(document, places);
}

void show_new(CanvasState& canvas, const std::set<std::string>& ids) {
    View& view = canvas.view;
    view.selected = view.reveal = ids;
    view.selected_wire.reset();
    std::erase_if(view.order, [&](const std::string& id) { return ids.contains(id); });
    view.order.insert(view.order.end(), ids.begin(), ids.end());
    canvas.layout_stale = true;
}

void reveal_new(CanvasState& canvas) {
    for (const std::string& id : canvas.view.reveal)
        if (const Card* card = canvas.layout.find(id)) bring_in_sight(canvas.view, *card);
    canvas.view.reveal.clear();
}

void keep_in_sight(CanvasState& canvas, ImVec2 extent) {
    View& view = canvas.view;
    if (extent.x >= view.extent.x && extent.y >= view.extent.y) return;
    for (const std::string& id : view.selected)
        if (const Card* card = canvas.layout.find(id); card && is_in_sight(view, *card))
            view.reveal.insert(id);
}

}  // namespace wrinkle::editor
