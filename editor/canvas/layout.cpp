#include "editor/canvas/layout.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/field.h"
#include "editor/look/draw.h"
#include "graph/edit.h"
#include "graph/order.h"

namespace wrinkle::editor {
namespace {

using Places = std::vector<ImVec2>;

// What of the surface and of the outputs is read or given.
struct Used {
    std::set<std::string, std::less<>> surface, inputs, outputs;
    std::set<std::pair<std::string, std::string>> links;  // outputs of nodes that are read
};

Used find_used(const Document& document) {
    Used used;
    const auto note = [&](const Link& link) {
        if (link.is_surface()) used.surface.insert(link.port);
        if (link.is_input()) used.inputs.insert(link.port);
        used.links.emplace(link.node, link.port);
    };
    for (const NodePtr& node : document.nodes)
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::link) note(input.link);
    for (const Output& output : document.outputs) {
        used.outputs.insert(output.name);
        if (output.from.kind == Input::Kind::link) note(output.from.link);
    }
    return used;
}

// Several numbers stand side by side behind their name; a single one has its name inside.
void add_field(Card& card, const Fonts& fonts, uint32_t index, const Port& port, float y) {
    const int lanes = lanes_of_field(port);
    const float named = lanes > 1 ? text_width(fonts.regular(16), 16, port.name) + 6 : 0;
    const float first = field_inset + named;
    const float width =
        (card.size.x - field_inset - first) / static_cast<float>(std::max(lanes, 1));
    for (int lane = 0; lane < std::max(lanes, 1); ++lane)
        card.fields.push_back(
            {port.name, index, lane, lanes, first + width * static_cast<float>(lane), y, width});
}

bool shows_field(const Port& port, bool connected) {
    if (connected) return false;
    return port.is_option() || lanes_of_field(port) > 0 || port.type == PortType::image_;
}

float width_of(const Fonts& fonts, const Card& card) {
    const auto width = [&](std::string_view text, float size, bool bold) {
        return text_width(bold ? fonts.bold(size) : fonts.regular(size), size, text);
    };
    const float label = std::min(width(card.label, 14, false), 80.0F);
    float wanted = 29 + width(card.id, 16, true) + 16 + label + 10;
    if (!card.type) return std::clamp(wanted, 104.0F, 240.0F);
    for (const Port& port : card.type->ports) {
        float row = 40 + width(port.name, 16, false);
        const bool wide = port.is_option() || (port.is_value() && lanes_of_field(port) > 0) ||
                          port.type == PortType::image_;
        if (port.kind != Port::Kind::output && wide)
            row += 48 + 44 * static_cast<float>(std::max(lanes_of_field(port) - 1, 0));
        wanted = std::max(wanted, row);
    }
    return std::clamp(std::ceil(wanted / 8) * 8, 104.0F, 240.0F);
}

// Ports as the document writes them, of a node whose type is not known.
void fill_unknown(Card& card, const Node& node, const Used& used) {
    float y = header_height;
    for (const auto& [from, port] : used.links) {
        if (from != node.id) continue;
        card.pins.push_back({port, PortType::float_, false, true, true, y + row_height / 2});
        y += row_height;
    }
    for (const Input& input : node.inputs) {
        const bool linked = input.kind == Input::Kind::link;
        card.pins.push_back(
            {input.port, PortType::float_, false, false, linked, y + row_height / 2});
        y += row_height;
    }
    card.size.y = y + 8;
}

void fill_ports(Card& card, const Fonts& fonts, const Node& node, const Used& used) {
    float y = header_height;
    for (const Port& port : card.type->ports) {
        if (port.kind != Port::Kind::output) continue;
        card.pins.push_back({port.name, port.type, true, true,
                             used.links.contains({node.id, port.name}), y + row_height / 2});
        y += row_height;
    }
    for (uint32_t i = 0; i < card.type->ports.size(); ++i) {
        const Port& port = card.type->ports[i];
        if (port.kind == Port::Kind::output) continue;
        const Input* input = node.find(port.name);
        const bool connected = input && input->kind == Input::Kind::link;
        if (port.is_value())
            card.pins.push_back({port.name, port.type, true, false, connected, y + row_height / 2});
        if (shows_field(port, connected)) add_field(card, fonts, i, port, y + 1.5F);
        y += row_height;
    }
    card.size.y = y + 8;
}

Card node_card(const State& state, const Node& node, const NodeType* type, ImVec2 at,
               const Used& used) {
    Card card;
    card.id = node.id;
    card.type = type;
    card.label = type ? type->title : node.type;
    card.muted = node.muted;
    card.at = at;
    card.size.x = width_of(state.fonts, card);
    if (type)
        fill_ports(card, state.fonts, node, used);
    else
        fill_unknown(card, node, used);
    return card;
}

// Depth in wires from the first nodes.
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

// The depth as a column; nodes of one column below each other.
Places automatic_places(const Document& document) {
    std::vector<float> next;
    Places places;
    const auto depth = depths(document);
    for (size_t i = 0; i < depth.size(); ++i) {
        if (next.size() <= depth[i]) next.resize(depth[i] + 1, 0);
        places.push_back({static_cast<float>(depth[i]) * 256, next[depth[i]]});
        next[depth[i]] +=
            72 + row_height * static_cast<float>(document.nodes[i]->inputs.size() + 2);
    }
    return places;
}

Places places_of(const Document& document) {
    Places places = automatic_places(document);
    for (size_t i = 0; i < document.nodes.size(); ++i)
        if (const Position* position = document.positions.find(document.nodes[i]->id))
            places[i] = {static_cast<float>(position->x), static_cast<float>(position->y)};
    return places;
}

void add_row(Card& card, std::string name, PortType type, bool output, bool connected) {
    const float y = header_height + row_height * static_cast<float>(card.pins.size());
    card.pins.push_back({std::move(name), type, true, output, connected, y + row_height / 2});
}

void close_card(Card& card, bool more) {
    card.size = {112, header_height + row_height * static_cast<float>(card.pins.size()) + 8};
    if (!more) return;
    card.more_y = card.size.y - 4;
    card.size.y += row_height - 4;
}

Card surface_card(const State& state, const Used& used) {
    Card card;
    card.kind = Card::Kind::surface;
    card.id = Link::surface;
    const std::set<std::string_view> usual = {"position", "normal", "uv0", "uv1"};
    for (const SurfaceProperty& property : surface_properties()) {
        const bool read = used.surface.contains(property.name);
        if (read || state.view.all_surface || usual.contains(property.name))
            add_row(card, std::string(property.name), property.type, true, read);
    }
    close_card(card, card.pins.size() < surface_properties().size() || state.view.all_surface);
    return card;
}

Card inputs_card(const State& state, const Used& used) {
    Card card;
    card.kind = Card::Kind::inputs;
    card.id = Link::input;
    for (const GraphInput& input : state.document().inputs)
        add_row(card, input.name, port_type_named(input.type).value_or(PortType::float_), true,
                used.inputs.contains(input.name));
    close_card(card, false);
    return card;
}

Card outputs_card(const State& state, const Used& used) {
    Card card;
    card.kind = Card::Kind::outputs;
    card.id = Card::outputs_id;
    const std::set<std::string_view> usual = {"normal", "height", "color", "roughness"};
    const auto standard = standard_outputs();
    for (const std::string_view name : standard)
        if (used.outputs.contains(name) || state.view.all_outputs || usual.contains(name))
            add_row(card, std::string(name), *standard_output(name), false,
                    used.outputs.contains(name));
    const bool more = card.pins.size() < standard.size() || state.view.all_outputs;
    for (const Output& output : state.document().outputs) {
        if (standard_output(output.name)) continue;
        const auto type = state.model.type_of(output.from.link);
        add_row(card, output.name, type.value_or(PortType::float_), false, true);
    }
    close_card(card, more);
    return card;
}

const Pin* find_pin(const Card& card, std::string_view port, bool output) {
    for (const Pin& pin : card.pins)
        if (pin.output == output && pin.port == port) return &pin;
    return nullptr;
}

class WireMaker {
public:
    explicit WireMaker(Layout& layout) : layout_(layout) {
        for (size_t i = 0; i < layout.cards.size(); ++i)
            if (layout.cards[i].kind == Card::Kind::node) by_id_.push_back(i);
        std::sort(by_id_.begin(), by_id_.end(),
                  [&](size_t a, size_t b) { return layout.cards[a].id < layout.cards[b].id; });
    }

    void add(const Link& from, const Card* reader, const std::string& port) {
        const Card* source = source_of(from);
        if (!source || !reader) return;
        const Pin* start = find_pin(*source, from.port, true);
        const Pin* end = find_pin(*reader, port, false);
        if (!start || !end) return;
        const bool known = start->known && end->known;
        layout_.wires.push_back({from, reader->kind == Card::Kind::node ? reader->id : "", port,
                                 pin_at(*source, *start), pin_at(*reader, *end), start->type,
                                 end->type, known});
    }

    const Card* node(std::string_view id) const {
        const auto found = std::lower_bound(
            by_id_.begin(), by_id_.end(), id,
            [&](size_t i, std::string_view wanted) { return layout_.cards[i].id < wanted; });
        if (found == by_id_.end() || layout_.cards[*found].id != id) return nullptr;
        return &layout_.cards[*found];
    }

private:
    const Card* source_of(const Link& link) const {
        if (link.is_surface()) return layout_.find(Link::surface, Card::Kind::surface);
        if (link.is_input()) return layout_.find(Link::input, Card::Kind::inputs);
        return node(link.node);
    }

    Layout& layout_;
    std::vector<size_t> by_id_;
};

void add_wires(const Document& document, Layout& layout) {
    WireMaker wires(layout);
    for (const NodePtr& node : document.nodes)
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::link)
                wires.add(input.link, wires.node(node->id), input.port);
    const Card* outputs = layout.find(Card::outputs_id, Card::Kind::outputs);
    for (const Output& output : document.outputs)
        if (output.from.kind == Input::Kind::link)
            wires.add(output.from.link, outputs, output.name);
}

void find_bounds(Layout& layout) {
    layout.low = {0, 0};
    layout.high = {0, 0};
    bool first = true;
    for (const Card& card : layout.cards) {
        const ImVec2 end = card.at + card.size;
        layout.low =
            first ? card.at
                  : ImVec2(std::min(layout.low.x, card.at.x), std::min(layout.low.y, card.at.y));
        layout.high =
            first ? end : ImVec2(std::max(layout.high.x, end.x), std::max(layout.high.y, end.y));
        first = false;
    }
}

ImVec2 drag_of(const State& state, const std::string& id) {
    const bool moves =
        state.gesture.kind == Gesture::Kind::move && state.view.selected.contains(id);
    return moves ? state.gesture.offset : ImVec2(0, 0);
}

void raise_cards(const State& state, Layout& layout) {
    for (const std::string& id : state.view.order) {
        const auto found = std::find_if(layout.cards.begin(), layout.cards.end(),
                                        [&](const Card& card) { return card.id == id; });
        if (found != layout.cards.end()) std::rotate(found, found + 1, layout.cards.end());
    }
}

}  // namespace

Layout lay_out(const State& state) {
    const Document& document = state.document();
    const Used used = find_used(document);
    const Places places = places_of(document);
    Layout layout;
    for (size_t i = 0; i < document.nodes.size(); ++i)
        layout.cards.push_back(node_card(state, *document.nodes[i], state.model.types->of(0, i),
                                         places[i] + drag_of(state, document.nodes[i]->id), used));
    find_bounds(layout);
    const ImVec2 low = layout.low, high = layout.high;
    Card surface = surface_card(state, used);
    surface.at = state.view.surface_at.value_or(ImVec2(low.x - 112 - 80, low.y)) +
                 drag_of(state, surface.id);
    Card outputs = outputs_card(state, used);
    outputs.at =
        state.view.outputs_at.value_or(ImVec2(high.x + 80, low.y)) + drag_of(state, outputs.id);
    if (!document.inputs.empty()) {
        Card inputs = inputs_card(state, used);
        inputs.at = surface.at + ImVec2(0, surface.size.y + 32);
        layout.cards.push_back(std::move(inputs));
    }
    layout.cards.push_back(std::move(surface));
    layout.cards.push_back(std::move(outputs));
    raise_cards(state, layout);
    find_bounds(layout);
    add_wires(document, layout);
    return layout;
}

Document tidied(const State& state) {
    const Document& document = state.document();
    const auto depth = depths(document);
    std::vector<float> next(document.nodes.size(), 0), width(document.nodes.size(), 0);
    std::vector<ImVec2> size(document.nodes.size(), ImVec2(0, 0));
    for (const Card& card : state.layout.cards)
        if (card.kind == Card::Kind::node) {
            const size_t i = document.nodes.index_of(card.id);
            size[i] = card.size;
            width[depth[i]] = std::max(width[depth[i]], card.size.x);
        }
    std::vector<float> left(document.nodes.size() + 1, 0);
    for (size_t i = 0; i < width.size(); ++i)
        left[i + 1] = left[i] + std::ceil(width[i] / 8) * 8 + 64;
    std::vector<NodePosition> places;
    for (size_t i = 0; i < depth.size(); ++i) {
        places.push_back({document.nodes[i]->id, left[depth[i]], next[depth[i]]});
        next[depth[i]] += std::ceil(size[i].y / 8) * 8 + 32;
    }
    return move_nodes(document, places);
}

ImVec2 pin_at(const Card& card, const Pin& pin) {
    return card.at + ImVec2(pin.output ? card.size.x : 0, pin.y);
}

ImVec2 free_place(const Layout& layout, ImVec2 at) {
    at = {std::round(at.x / 8) * 8, std::round(at.y / 8) * 8};
    const auto covered = [&] {
        return std::any_of(layout.cards.begin(), layout.cards.end(), [&](const Card& card) {
            return std::fabs(card.at.x - at.x) < 24 && std::fabs(card.at.y - at.y) < 24;
        });
    };
    while (covered())
        at = at + ImVec2(32, 32);
    return at;
}

}  // namespace wrinkle::editor
