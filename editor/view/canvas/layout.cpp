#include "editor/view/canvas/layout.h"

#include <algorithm>

#include "editor/model/document/change.h"
#include "editor/model/document/knots.h"
#include "editor/model/document/wiring.h"
#include "editor/view/canvas/columns.h"
#include "editor/view/canvas/make_card.h"
#include "editor/view/look/draw.h"
#include "editor/view/preview/knot_values.h"
#include "graph/edit.h"
#include "graph/order.h"

namespace wrinkle::editor {
namespace {

constexpr auto none = ~uint32_t{0};

// Readers of each output of each node, found in one pass over the links of a document.
struct Readers {
    std::vector<std::vector<std::string_view>> ports;  // by node: outputs that are read
    std::vector<uint64_t> key;                         // by node: sum of hashes of `ports`
    Used used;
};

Readers find_readers(const Document& document) {
    Readers readers;
    readers.ports.resize(document.nodes.size());
    readers.key.resize(document.nodes.size());
    each_link(document, [&](const Link& from, const std::string&, const std::string&) {
        if (from.is_surface()) {
            readers.used.surface.insert(from.port);
        } else if (from.is_input()) {
            readers.used.inputs.insert(from.port);
        } else if (const size_t i = document.nodes.index_of(from.node); i != Table<NodePtr>::npos) {
            readers.ports[i].push_back(from.port);
            readers.key[i] += std::hash<std::string_view>{}(from.port);
        }
    });
    return readers;
}

// Types of sub-graphs and reroutes are created again with each model.
bool has_lasting_type(const Node& node) {
    return !node.subgraph() && node.type != reroute_type;
}

// Returns the card of a node from the previous layout if nothing about it changed.
std::optional<Card> reused_card(Layout& old, size_t index, const NodePtr& node,
                                const NodeType* type, uint64_t readers, Shown shown) {
    if (index >= old.nodes.size() || old.nodes[index] != node) index = old.nodes.index_of(node->id);
    if (index == Table<NodePtr>::npos || old.nodes[index] != node ||
        old.readers[index] != readers || !has_lasting_type(*node))
        return std::nullopt;
    Card& card = old.cards[old.card_of_node[index]];
    if (card.type != type || (card.preview_y >= 0) != shown.preview) return std::nullopt;
    if (!card.more.empty() && card.unfolded != shown.unfolded) return std::nullopt;
    return std::move(card);
}

// Extent of a card with its pins and shadow.
Extent box_of(const Card& card) {
    return {card.at - ImVec2(9, 3), card.at + card.size + ImVec2(9, 6)};
}

void find_bounds(Layout& layout) {
    layout.bounds = layout.cards.empty() ? Extent{{0, 0}, {0, 0}} : Extent();
    for (const Card& card : layout.cards)
        layout.bounds.add(card.extent());
}

// Derives types, conversion, end points and bounding box of a wire from its cards.
void fit_wire(const Layout& layout, Wire& wire, Extent& box) {
    const Card &from = layout.cards[wire.from_card], &to = layout.cards[wire.to_card];
    const Pin& start = *find_pin(from, wire.from.port, true);
    const Pin& end = *find_pin(to, wire.port, false);
    wire.from_type = start.type;
    wire.to_type = end.type;
    wire.known = start.known && end.known;
    wire.conversion = wire.known ? conversion(start.type, end.type) : Conversion::same;
    wire.start = pin_at(from, start);
    wire.end = pin_at(to, end);
    const Curve k = wire_curve(wire.start, wire.end, 1);
    box.low = {std::min(k.a.x, k.c.x) - 4, std::min(k.a.y, k.d.y) - 4};
    box.high = {std::max(k.d.x, k.b.x) + 4, std::max(k.a.y, k.d.y) + 4};
}

// Adds the wire if both cards have its pins.
void add_wire(Layout& layout, const Link& from, uint32_t source, uint32_t reader,
              const std::string& port) {
    if (source == none || reader == none) return;
    const Card& to = layout.cards[reader];
    if (!find_pin(layout.cards[source], from.port, true) || !find_pin(to, port, false)) return;
    Wire& wire = layout.wires.emplace_back();
    wire.from = from;
    wire.node = to.link_id();
    wire.port = port;
    wire.from_card = source;
    wire.to_card = reader;
    fit_wire(layout, wire, layout.wire_boxes.emplace_back());
}

uint32_t card_of_kind(const Layout& layout, Card::Kind kind) {
    for (size_t i = layout.cards.size(); i-- > 0;)
        if (layout.cards[i].kind == kind) return static_cast<uint32_t>(i);
    return none;
}

void add_wires(const Document& document, Layout& layout) {
    const uint32_t surface = card_of_kind(layout, Card::Kind::surface);
    const uint32_t inputs = card_of_kind(layout, Card::Kind::inputs);
    const uint32_t outputs = card_of_kind(layout, Card::Kind::outputs);
    const auto card_of = [&](const std::string& node) {
        const size_t index = document.nodes.index_of(node);
        return index == Table<NodePtr>::npos ? none : layout.card_of_node[index];
    };
    each_link(document, [&](const Link& from, const std::string& node, const std::string& port) {
        const uint32_t source = from.is_surface() ? surface
                                : from.is_input() ? inputs
                                                  : card_of(from.node);
        add_wire(layout, from, source, node.empty() ? outputs : card_of(node), port);
    });
}

// Node cards in document order, then the surface, inputs and outputs cards; raised cards on top.
void order_cards(const State& state, Layout& layout) {
    std::vector<uint32_t> order, raised;
    std::vector<bool> is_raised(layout.cards.size(), false);
    for (auto id = state.view.order.rbegin(); id != state.view.order.rend(); ++id) {
        size_t i = layout.nodes.index_of(*id);
        for (size_t k = layout.nodes.size(); i == Table<NodePtr>::npos && k < layout.cards.size();
             ++k)
            if (layout.cards[k].id == *id) i = k;
        if (i == Table<NodePtr>::npos || is_raised[i]) continue;
        is_raised[i] = true;
        raised.push_back(static_cast<uint32_t>(i));
    }
    for (uint32_t i = 0; i < layout.cards.size(); ++i)
        if (!is_raised[i]) order.push_back(i);
    order.insert(order.end(), raised.rbegin(), raised.rend());
    std::vector<Card> cards;
    cards.reserve(order.size());
    layout.card_of_node.resize(layout.nodes.size());
    for (const uint32_t i : order) {
        if (i < layout.nodes.size()) layout.card_of_node[i] = static_cast<uint32_t>(cards.size());
        cards.push_back(std::move(layout.cards[i]));
    }
    layout.cards = std::move(cards);
}

void add_border_cards(State& state, Layout& layout, const Used& used) {
    find_bounds(layout);
    const ImVec2 low = layout.bounds.low;
    Card surface = make_surface_card(state, used), outputs = make_outputs_card(state);
    if (!state.view.surface_at) state.view.surface_at = ImVec2(low.x - surface.size.x - 80, low.y);
    if (!state.view.outputs_at) state.view.outputs_at = ImVec2(layout.bounds.high.x + 80, low.y);
    surface.at = *state.view.surface_at;
    outputs.at = *state.view.outputs_at;
    if (!state.document().inputs.empty()) {
        Card inputs = make_inputs_card(state, used);
        inputs.at = surface.at + ImVec2(0, surface.size.y + 32);
        layout.cards.push_back(std::move(inputs));
    }
    layout.cards.push_back(std::move(surface));
    layout.cards.push_back(std::move(outputs));
}

Layout lay_out(State& state) {
    const Document& document = state.document();
    const Readers readers = find_readers(document);
    Layout layout;
    layout.fonts = state.fonts.generation();
    layout.cards.reserve(document.nodes.size() + 3);
    Layout& old = state.layout;
    if (old.fonts != layout.fonts) old.nodes = {};
    std::vector<ImVec2> sizes;
    sizes.reserve(document.nodes.size());
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const NodePtr& node = document.nodes[i];
        const NodeType* type = state.model.types->of(0, i);
        const Shown shown = shown_of(state.view, *node, type);
        auto card = reused_card(old, i, node, type, readers.key[i], shown);
        if (!card) {
            card = make_card(state.fonts, *node, type, readers.ports[i], shown);
            if (is_ramp(type)) card->strip = ramp_colors(*node, *state.registry);
            if (is_curve(type)) card->values = curve_values(*node, *state.registry);
            ++layout.made;
        }
        layout.cards.push_back(std::move(*card));
        sizes.push_back(layout.cards.back().size);
    }
    const std::vector<ImVec2> places = places_of(document, sizes);
    for (size_t i = 0; i < places.size(); ++i)
        layout.cards[i].at = places[i];
    layout.nodes = document.nodes;
    layout.readers = readers.key;
    add_border_cards(state, layout, readers.used);
    order_cards(state, layout);
    layout.card_boxes.reserve(layout.cards.size());
    for (const Card& card : layout.cards)
        layout.card_boxes.push_back(box_of(card));
    add_wires(document, layout);
    find_bounds(layout);
    return layout;
}

// Moves the dragged cards and the ends of their wires.
void drag_cards(const State& state, Layout& layout) {
    const ImVec2 wanted =
        state.gesture.kind == Gesture::Kind::move ? state.gesture.offset : ImVec2(0, 0);
    const ImVec2 by = wanted - layout.dragged;
    if (by.x == 0 && by.y == 0) return;
    layout.dragged = wanted;
    std::vector<bool> moves(layout.cards.size(), false);
    for (size_t i = 0; i < layout.cards.size(); ++i) {
        Card& card = layout.cards[i];
        moves[i] = state.gesture.carried.contains(
            card.kind == Card::Kind::inputs ? std::string(Link::surface) : card.id);
        if (!moves[i]) continue;
        card.at = card.at + by;
        layout.card_boxes[i] = box_of(card);
    }
    for (size_t i = 0; i < layout.wires.size(); ++i)
        if (moves[layout.wires[i].from_card] || moves[layout.wires[i].to_card])
            fit_wire(layout, layout.wires[i], layout.wire_boxes[i]);
    find_bounds(layout);
}

// Returns the length in links of the longest path to each node, by index.
std::vector<size_t> depths(const Document& document) {
    std::vector<size_t> depth(document.nodes.size(), 0);
    std::vector<bool> done(document.nodes.size(), false);
    for (const uint32_t index : evaluation_order(document)) {
        for (const Input& input : document.nodes[index]->inputs) {
            if (input.kind != Input::Kind::link || !input.link.is_node()) continue;
            const size_t from = document.nodes.index_of(input.link.node);
            if (from != Table<NodePtr>::npos && done[from])
                depth[index] = std::max(depth[index], depth[from] + 1);
        }
        done[index] = true;
    }
    return depth;
}

}  // namespace

const Card* Layout::find(std::string_view id, Card::Kind kind) const {
    if (kind == Card::Kind::node) {
        const size_t index = nodes.index_of(id);
        return index < card_of_node.size() ? &cards[card_of_node[index]] : nullptr;
    }
    for (const Card& card : cards)
        if (card.kind == kind && card.id == id) return &card;
    return nullptr;
}

const Wire* Layout::wire_to(const Link& input) const {
    for (const Wire& wire : wires)
        if (wire.ends_at(input)) return &wire;
    return nullptr;
}

std::vector<Extent> places_off_canvas(const State& state, const Document& document) {
    std::vector<ImVec2> sizes;
    const Model model = make_model(document, state.folder(), *state.registry);
    const Readers readers = find_readers(document);
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const Node& node = *document.nodes[i];
        const NodeType* type = model.types->of(0, i);
        sizes.push_back(
            make_card(state.fonts, node, type, readers.ports[i], shown_of(state.view, node, type))
                .size);
    }
    std::vector<Extent> extents;
    for (const ImVec2 at : places_of(document, sizes))
        extents.push_back({at, at + sizes[extents.size()]});
    return extents;
}

void update_layout(State& state) {
    const Document& now = state.document();
    const bool drag_ended = state.gesture.kind != Gesture::Kind::move &&
                            (state.layout.dragged.x != 0 || state.layout.dragged.y != 0);
    if (state.layout_stale || drag_ended || state.layout.fonts != state.fonts.generation() ||
        !same_document(state.layout_of, now)) {
        state.layout = lay_out(state);
        state.layout_of = now;
        state.layout_stale = false;
    }
    drag_cards(state, state.layout);
}

std::vector<const Card*> selected_cards(const State& state) {
    std::vector<const Card*> cards;
    for (const Card& card : state.layout.cards)
        if (card.kind == Card::Kind::node && state.view.selected.contains(card.id))
            cards.push_back(&card);
    return cards;
}

const Pin* find_pin(const Card& card, std::string_view port, bool output) {
    for (const Pin& pin : card.pins)
        if (pin.output == output && pin.port == port) return &pin;
    return nullptr;
}

ImVec2 pin_at(const Card& card, const Pin& pin) {
    return card.at + ImVec2(pin.output ? card.size.x : 0, pin.y);
}

std::vector<ImVec2> places_of(const Document& document, const std::vector<ImVec2>& sizes) {
    std::vector<ImVec2> places;
    std::vector<size_t> without;
    ImVec2 corner(0, 0);
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const Position* at = document.positions.find(document.nodes[i]->id);
        const ImVec2 place =
            at ? ImVec2(static_cast<float>(at->x), static_cast<float>(at->y)) : ImVec2(0, 0);
        if (!at) without.push_back(i);
        const bool first = at && places.size() == without.size();
        if (at) corner.x = first ? place.x : std::min(corner.x, place.x);
        if (at) corner.y = std::max(first ? place.y : corner.y, place.y + sizes[i].y + row_gap);
        places.push_back(place);
    }
    if (without.empty()) return places;
    // Columns by depth, each as wide as its widest card; a column without nodes has no width.
    const std::vector<size_t> depth = depths(document);
    std::vector<float> width(depth.size(), 0), left(depth.size() + 1, corner.x),
        next(depth.size(), grid_up(corner.y));
    for (const size_t i : without)
        width[depth[i]] = std::max(width[depth[i]], sizes[i].x);
    for (size_t i = 0; i < width.size(); ++i)
        left[i + 1] = left[i] + (width[i] > 0 ? grid_up(width[i]) + column_gap : 0);
    for (const size_t i : without) {
        places[i] = {left[depth[i]], next[depth[i]]};
        next[depth[i]] += grid_up(sizes[i].y) + row_gap;
    }
    return places;
}

}  // namespace wrinkle::editor
