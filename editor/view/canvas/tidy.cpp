#include "editor/view/canvas/arrange.h"

#include <algorithm>
#include <cmath>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/columns.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"
#include "graph/order.h"

namespace wrinkle::editor {
namespace {

// Converts cards and wires to boxes and lines, and maps the resulting positions back to cards.
class Tidier {
    static constexpr auto no_box = ~size_t{0};

public:
    // Arranges all cards, or only the nodes in `only`.
    Tidier(const State& state, const std::set<std::string>* only)
        : state_(state), layout_(state.layout), box_of_(layout_.cards.size(), no_box) {
        for (size_t i = 0; i < layout_.cards.size(); ++i) {
            const Card& card = layout_.cards[i];
            if (card.kind == Card::Kind::inputs) continue;  // moves with the surface card
            const bool node = card.kind == Card::Kind::node;
            if (only && !(node && only->contains(card.id))) continue;
            box_of_[i] = boxes_.size();
            cards_.push_back(i);
            boxes_.push_back({card.size, 0, 0, card.at});
        }
        join_inputs();
        add_lines();
        find_columns();
        find_groups();
        place_in_columns(boxes_, lines_);
    }

    ImVec2 place(size_t card) const { return boxes_[box_of_[card]].at; }
    bool has(size_t card) const { return box_of_[card] != no_box; }

private:
    size_t index(const Card& card) const { return static_cast<size_t>(&card - &layout_.cards[0]); }

    void join_inputs() {
        const Card* inputs = layout_.find(Link::input, Card::Kind::inputs);
        const Card* surface = layout_.find(Link::surface, Card::Kind::surface);
        if (!inputs || !surface || !has(index(*surface))) return;
        ColumnBox& box = boxes_[box_of_[index(*surface)]];
        box_of_[index(*inputs)] = box_of_[index(*surface)];
        box.size = {std::max(box.size.x, inputs->size.x),
                    inputs->at.y + inputs->size.y - surface->at.y};
    }

    void add_lines() {
        for (const Wire& wire : layout_.wires) {
            const size_t from = box_of_[wire.from_card], to = box_of_[wire.to_card];
            if (from == no_box || to == no_box) continue;
            lines_.push_back(
                {from, to, wire.start.y - boxes_[from].at.y, wire.end.y - boxes_[to].at.y});
        }
    }

    // Assigns columns by depth. Then moves each box with no more wires from nodes than wires to
    // readers to the column left of its nearest reader. Ignores wires that close a cycle.
    void find_columns() {
        std::vector<size_t> order;
        for (const uint32_t node : evaluation_order(state_.document()))
            if (const size_t box = box_of_[layout_.card_of_node[node]]; box != no_box)
                order.push_back(box);
        std::vector<std::vector<size_t>> into(boxes_.size()), from(boxes_.size());
        for (size_t l = 0; l < lines_.size(); ++l) {
            into[lines_[l].to].push_back(l);
            from[lines_[l].from].push_back(l);
        }
        std::vector<bool> done(boxes_.size(), false);
        const bool borders = order.size() < boxes_.size();
        size_t last = 0;
        for (size_t i = 0; i < boxes_.size(); ++i)
            done[i] = layout_.cards[cards_[i]].kind == Card::Kind::surface;
        for (const size_t box : order) {
            size_t& column = boxes_[box].column;
            column = borders;
            for (const size_t l : into[box])
                if (done[lines_[l].from])
                    column = std::max(column, boxes_[lines_[l].from].column + 1);
            done[box] = true;
            last = std::max(last, column);
        }
        for (size_t i = 0; i < boxes_.size(); ++i)
            if (layout_.cards[cards_[i]].kind == Card::Kind::outputs) boxes_[i].column = last + 1;
        for (size_t n = order.size(); n-- > 0;)
            pull(order[n], into[order[n]], from[order[n]]);
        std::erase_if(lines_, [&](const ColumnLine& line) {
            return boxes_[line.from].column >= boxes_[line.to].column;
        });
    }
    void pull(size_t box, const std::vector<size_t>& into, const std::vector<size_t>& from) {
        const auto fed = std::ranges::count_if(into, [&](size_t l) {
            return layout_.cards[cards_[lines_[l].from]].kind == Card::Kind::node;
        });
        if (from.empty() || fed > static_cast<std::ptrdiff_t>(from.size())) return;
        size_t nearest = no_box;
        for (const size_t l : from)
            nearest = std::min(nearest, boxes_[lines_[l].to].column);
        if (nearest > boxes_[box].column + 1) boxes_[box].column = nearest - 1;
    }

    // Assigns each card to the innermost frame that contains it.
    void find_groups() {
        std::vector<float> area(boxes_.size(), 0);
        size_t group = 0;
        for (const Box& frame : state_.document().frames) {
            std::set<std::string> ids;
            std::set<BoxId> ignored;
            add_contents(state_, {false, frame.id}, ids, ignored);
            ++group;
            const auto size = static_cast<float>(frame.rect.width * frame.rect.height);
            for (size_t i = 0; i < boxes_.size(); ++i)
                if (ids.contains(layout_.cards[cards_[i]].id) && (area[i] == 0 || size < area[i])) {
                    boxes_[i].group = group;
                    area[i] = size;
                }
        }
    }

    const State& state_;
    const Layout& layout_;
    std::vector<size_t> box_of_;  // by card
    std::vector<size_t> cards_;   // by box
    std::vector<ColumnBox> boxes_;
    std::vector<ColumnLine> lines_;
};

// Fits the frame around the cards that were in it; its notes keep their positions relative to it.
Document with_frame_moved(const State& state, const Tidier& tidier, Document document,
                          const Box& frame) {
    constexpr float inset = 24;
    std::set<std::string> ids;
    std::set<BoxId> boxes;
    add_contents(state, {false, frame.id}, ids, boxes);
    Extent around;
    for (size_t i = 0; i < state.layout.cards.size(); ++i) {
        const Card& card = state.layout.cards[i];
        if (!ids.contains(card.id)) continue;
        const ImVec2 low = tidier.has(i) ? tidier.place(i) : card.at;
        around.add({low, low + card.size});
    }
    if (around.empty()) return document;
    Box moved = frame;
    moved.rect.x = std::floor((around.low.x - inset) / grid) * grid;
    moved.rect.y = std::floor((around.low.y - inset - title_height) / grid) * grid;
    moved.rect.width = grid_up(around.high.x + inset) - static_cast<float>(moved.rect.x);
    moved.rect.height = grid_up(around.high.y + inset) - static_cast<float>(moved.rect.y);
    for (const BoxId& id : boxes) {
        if (!id.note) continue;
        Box note = *find_box(document, id);
        note.rect.x += moved.rect.x - frame.rect.x;
        note.rect.y += moved.rect.y - frame.rect.y;
        document = with_box(document, true, std::move(note));
    }
    return with_box(document, false, std::move(moved));
}

}  // namespace

Tidied tidied(const State& state) {
    const Tidier tidier(state, nullptr);
    Tidied result{state.document(), {}};
    std::vector<NodePosition> places;
    for (size_t i = 0; i < state.layout.cards.size(); ++i) {
        const Card& card = state.layout.cards[i];
        if (!tidier.has(i)) continue;
        const ImVec2 at = tidier.place(i);
        if (card.kind == Card::Kind::node) places.push_back({card.id, at.x, at.y});
        if (card.kind == Card::Kind::surface) result.borders.surface_at = at;
        if (card.kind == Card::Kind::outputs) result.borders.outputs_at = at;
    }
    result.document = move_nodes(state.document(), places);
    for (const Box& frame : state.document().frames)
        result.document = with_frame_moved(state, tidier, std::move(result.document), frame);
    return result;
}

Document tidied_selection(const State& state) {
    const Tidier tidier(state, &state.view.selected);
    Extent before;
    std::vector<NodePosition> places;
    for (size_t i = 0; i < state.layout.cards.size(); ++i) {
        if (!tidier.has(i)) continue;
        const Card& card = state.layout.cards[i];
        before.add(card.extent());
        places.push_back({card.id, tidier.place(i).x, tidier.place(i).y});
    }
    for (NodePosition& place : places)
        place.x += before.low.x, place.y += before.low.y;
    return move_nodes(state.document(), places);
}

}  // namespace wrinkle::editor
