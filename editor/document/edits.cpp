#include "editor/document/edits.h"

#include "base/text.h"
#include "editor/canvas/field.h"
#include "editor/canvas/layout.h"
#include "graph/edit.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

bool converts(PortType from, PortType to) {
    return conversion(from, to) != Conversion::illegal;
}

// Equal types first, else the first that converts; null when none fits.
const Port* port_for(const NodeType& type, const Gesture& wire) {
    const Port* found = nullptr;
    for (const Port& port : type.ports) {
        const bool faces = wire.from_output ? port.is_value() : port.kind == Port::Kind::output;
        if (!faces) continue;
        if (port.type == wire.type) return &port;
        const bool fits =
            wire.from_output ? converts(wire.type, port.type) : converts(port.type, wire.type);
        if (fits && !found) found = &port;
    }
    return found;
}

}  // namespace

std::optional<Link> link_at(const Document& document, const std::string& node,
                            const std::string& port) {
    const Input* input = nullptr;
    if (node.empty()) {
        const Output* output = document.outputs.find(port);
        input = output ? &output->from : nullptr;
    } else if (const Node* reader = document.find(node)) {
        input = reader->find(port);
    }
    if (!input || input->kind != Input::Kind::link) return std::nullopt;
    return input->link;
}

Document with_wire(const Document& document, const Link& from, const std::string& node,
                   const std::string& port) {
    return node.empty() ? set_output(document, port, from) : connect(document, from, node, port);
}

Document without_wire(const Document& document, const std::string& node, const std::string& port) {
    return node.empty() ? remove_output(document, port) : disconnect(document, node, port);
}

bool type_fits(const NodeType& type, const Gesture& wire) {
    return wire.kind != Gesture::Kind::wire || port_for(type, wire);
}

bool type_matches(const NodeType& type, const Gesture& wire) {
    if (wire.kind != Gesture::Kind::wire) return true;
    const Port* port = port_for(type, wire);
    return port && port->type == wire.type;
}

void add_node_of_type(State& state, const NodeType& type, ImVec2 at, const Gesture& wire) {
    Node node;
    node.id = free_id(state.document(), type.id);
    node.type = type.id;
    node.version = static_cast<int>(type.version);
    const std::string id = node.id;
    const ImVec2 place = free_place(state.layout, at);
    Document document = add_node(state.document(), std::move(node), place.x, place.y);
    if (const Port* port = wire.kind == Gesture::Kind::wire ? port_for(type, wire) : nullptr)
        document = wire.from_output ? connect(document, wire.from, id, port->name)
                                    : with_wire(document, {id, port->name}, wire.node, wire.port);
    state.commit("Add " + type.title, std::move(document));
    state.view.selected = {id};
}

void delete_selected(State& state) {
    if (const auto wire = state.view.selected_wire) {
        state.commit("Delete wire", without_wire(state.document(), wire->node, wire->port));
        state.view.selected_wire.reset();
        return;
    }
    Document document = remove_nodes(state.document(), state.view.selected);
    const size_t count = state.document().nodes.size() - document.nodes.size();
    state.commit(count == 1 ? "Delete 1 node" : "Delete " + std::to_string(count) + " nodes",
                 std::move(document));
    state.view.selected.clear();
}

void duplicate_selected(State& state) {
    std::set<std::string> copies;
    std::vector<Node> nodes;
    std::vector<NodePosition> places;
    for (const Card& card : state.layout.cards) {
        const Node* node = state.document().find(card.id);
        if (!node || card.kind != Card::Kind::node || !state.view.selected.contains(card.id))
            continue;
        Node copy = *node;
        copy.id = free_id(state.document(), node->id, copies);
        copies.insert(copy.id);
        places.push_back({copy.id, card.at.x + 32, card.at.y + 32});
        nodes.push_back(std::move(copy));
    }
    state.commit("Duplicate", add_nodes(state.document(), std::move(nodes), places));
    if (!copies.empty()) state.view.selected = copies;
}

void mute_selected(State& state) {
    const Document& document = state.document();
    bool any_loud = false;
    for (const std::string& id : state.view.selected)
        if (const Node* node = document.find(id)) any_loud |= !node->muted;
    state.commit(any_loud ? "Mute" : "Unmute", mute_nodes(document, state.view.selected, any_loud));
}

std::string why_not(const State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    if (pin.output == wire.from_output)
        return pin.output ? "a wire ends at an input" : "a wire begins at an output";
    const Link from = wire.from_output ? wire.from : Link{card.id, pin.port};
    const std::string to = !wire.from_output                  ? wire.node
                           : card.kind == Card::Kind::outputs ? ""
                                                              : card.id;
    const std::string port = wire.from_output ? pin.port : wire.port;
    if (to.empty()) return output_problem(state.model, from, port, *state.registry);
    const std::string& loose = wire.from_output ? to : from.node;
    if (wire.loops.contains(loose))
        return from.text() + " depends on " + to + ": that would be a loop";
    return wire_problem(state.model, state.document(), *state.registry, from, to, port);
}

void find_loops(const Document& document, Gesture& wire) {
    wire.loops =
        cycle_partners(document, wire.from_output ? wire.from.node : wire.node, wire.from_output);
}

std::string typed_value(const Node& node, const Port& port, int lane) {
    return shortest(numbers_at(node, port)[static_cast<size_t>(lane)]);
}

void open_palette(State& state, ImVec2 at, const Gesture& wire) {
    state.palette = {};
    state.palette.open = state.palette.opening = true;
    state.palette.at = at;
    state.palette.wire = wire;
}

}  // namespace wrinkle::editor
