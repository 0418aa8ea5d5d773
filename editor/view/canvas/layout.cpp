#include "editor/view/canvas/layout.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "editor/model/document/history.h"
#include "editor/view/canvas/make_card.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr auto none = ~uint32_t{0};

// Readers of each output of each node, found in one pass over the links of a document.
struct Readers {
    std::vector<uint32_t> source;         // by link, in document order: index of a node, or `none`
    std::vector<uint32_t> first;          // by node: index of its first output in `ports`
    std::vector<std::string_view> ports;  // outputs that are read, grouped by node
    std::vector<uint64_t> key;            // by node: sum of hashes of the outputs that are read
    Used used;

    std::span<const std::string_view> of(size_t node) const {
        return {ports.data() + first[node], ports.data() + first[node + 1]};
    }
};

template <class Each>
void each_link(const Document& document, Each each) {
    for (const NodePtr& node : document.nodes)
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::link) each(input.link);
    for (const Output& output : document.outputs)
        if (output.from.kind == Input::Kind::link) each(output.from.link);
}

Readers find_readers(const Document& document) {
    Readers readers;
    readers.first.assign(document.nodes.size() + 1, 0);
    readers.key.assign(document.nodes.size(), 0);
    each_link(document, [&](const Link& link) {
        uint32_t source = none;
        if (link.is_surface())
            readers.used.surface.insert(link.port);
        else if (link.is_input())
            readers.used.inputs.insert(link.port);
        else if (const size_t i = document.nodes.index_of(link.node); i != Table<NodePtr>::npos)
            source = static_cast<uint32_t>(i);
        readers.source.push_back(source);
        if (source == none) return;
        ++readers.first[source + 1];
        readers.key[source] += std::hash<std::string_view>{}(link.port);
    });
    for (size_t i = 0; i < document.nodes.size(); ++i)
        readers.first[i + 1] += readers.first[i];
    readers.ports.resize(readers.first.back());
    std::vector<uint32_t> next = readers.first;
    size_t i = 0;
    each_link(document, [&](const Link& link) {
        if (const uint32_t source = readers.source[i++]; source != none)
            readers.ports[next[source]++] = link.port;
    });
    return readers;
}

// Types of sub-graphs and reroutes are created again with each model.
bool has_lasting_type(const Node& node) {
    return !node.subgraph() && node.type != reroute_type;
}

class CardTaker {
public:
    CardTaker(const State& state, Layout& old, const Readers& readers)
        : state_(state), old_(old), readers_(readers) {
        if (old.fonts != state.fonts.generation()) old.nodes = {};
    }

    // Returns the card of a node, reused from the previous layout if nothing about it changed.
    Card take(size_t index) {
        const NodePtr& node = state_.document().nodes[index];
        const NodeType* type = state_.model.types->of(0, index);
        const bool preview = has_preview(state_.view, *node, type);
        const size_t before = index_before(index, node);
        if (before != Table<NodePtr>::npos && old_.readers[before] == readers_.key[index] &&
            has_lasting_type(*node)) {
            Card& card = old_.cards[old_.card_of_node[before]];
            if (card.type == type && (card.preview_y >= 0) == preview) return std::move(card);
        }
        ++made;
        return make_card(state_.fonts, *node, type, readers_.of(index), preview);
    }

    size_t made = 0;

private:
    size_t index_before(size_t index, const NodePtr& node) const {
        if (index < old_.nodes.size() && old_.nodes[index] == node) return index;
        const size_t found = old_.nodes.index_of(node->id);
        const bool same = found != Table<NodePtr>::npos && old_.nodes[found] == node;
        return same ? found : Table<NodePtr>::npos;
    }

    const State& state_;
    Layout& old_;
    const Readers& readers_;
};

const Pin* find_pin(const Card& card, std::string_view port, bool output) {
    for (const Pin& pin : card.pins)
        if (pin.output == output && pin.port == port) return &pin;
    return nullptr;
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

void add_wires(const Document& document, const Readers& readers, Layout& layout) {
    const uint32_t surface = card_of_kind(layout, Card::Kind::surface);
    const uint32_t inputs = card_of_kind(layout, Card::Kind::inputs);
    size_t link = 0;
    const auto source = [&](const Link& from) {
        const uint32_t node = readers.source[link++];
        if (node != none) return layout.card_of_node[node];
        return from.is_surface() ? surface : from.is_input() ? inputs : none;
    };
    for (size_t i = 0; i < document.nodes.size(); ++i)
        for (const Input& input : document.nodes[i]->inputs)
            if (input.kind == Input::Kind::link)
                add_wire(layout, input.link, source(input.link), layout.card_of_node[i],
                         input.port);
    const uint32_t outputs = card_of_kind(layout, Card::Kind::outputs);
    for (const Output& output : document.outputs)
        if (output.from.kind == Input::Kind::link)
            add_wire(layout, output.from.link, source(output.from.link), outputs, output.name);
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
    CardTaker taker(state, state.layout, readers);
    std::vector<ImVec2> sizes;
    sizes.reserve(document.nodes.size());
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        layout.cards.push_back(taker.take(i));
        sizes.push_back(layout.cards.back().size);
    }
    const std::vector<ImVec2> places = places_of(document, sizes);
    for (size_t i = 0; i < places.size(); ++i)
        layout.cards[i].at = places[i];
    layout.made = taker.made;
    layout.nodes = document.nodes;
    layout.readers = readers.key;
    add_border_cards(state, layout, readers.used);
    order_cards(state, layout);
    layout.card_boxes.reserve(layout.cards.size());
    for (const Card& card : layout.cards)
        layout.card_boxes.push_back(box_of(card));
    add_wires(document, readers, layout);
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

std::vector<Extent> places_off_canvas(const State& state, const Document& document) {
    std::vector<ImVec2> sizes;
    const Model model = make_model(document, state.folder(), *state.registry);
    const Readers readers = find_readers(document);
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const Node& node = *document.nodes[i];
        const NodeType* type = model.types->of(0, i);
        sizes.push_back(
            make_card(state.fonts, node, type, readers.of(i), has_preview(state.view, node, type))
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

ImVec2 pin_at(const Card& card, const Pin& pin) {
    return card.at + ImVec2(pin.output ? card.size.x : 0, pin.y);
}

}  // namespace wrinkle::editor
