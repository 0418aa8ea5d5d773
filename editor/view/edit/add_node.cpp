// Adds nodes: loose, at the end of a wire, in a wire, after the selection.
#include <algorithm>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// Returns the first port of an equal type, else the first that converts; nullptr if none fits.
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

void commit_new(State& state, const NodeType& type, const std::string& id, Document document) {
    state.commit("Add " + type.title, settled(state, document));
    show_new(state, {id});
}

// Returns the selected cards with a typed first output, from top to bottom.
std::vector<const Card*> givers(const State& state) {
    std::vector<const Card*> found;
    for (const Card& card : state.layout.cards)
        if (card.kind == Card::Kind::node && state.view.selected.contains(card.id) &&
            !card.pins.empty() && card.pins.front().output && card.pins.front().known)
            found.push_back(&card);
    std::sort(found.begin(), found.end(), [](const Card* a, const Card* b) {
        return std::pair(a->at.y, a->at.x) < std::pair(b->at.y, b->at.x);
    });
    return found;
}

// Returns the first free input of the same type, else the first that converts; nullptr if none.
const Port* free_port(const NodeType& type, const Node& node, PortType given) {
    const Port* found = nullptr;
    for (const Port& port : type.ports) {
        if (!port.is_value() || node.find(port.name)) continue;
        if (port.type == given) return &port;
        if (!found && converts(given, port.type)) found = &port;
    }
    return found;
}

// Inserts the node in the selected wire; returns false if there is none or it does not fit.
bool add_in_wire(State& state, const NodeType& type) {
    if (!state.view.selected_wire) return false;
    const Link end = *state.view.selected_wire;
    const auto wire = std::find_if(state.layout.wires.begin(), state.layout.wires.end(),
                                   [&](const Wire& each) { return each.ends_at(end); });
    if (wire == state.layout.wires.end() || !wire->known) return false;
    const auto through =
        passage(type, wire->from_type, wanted_at(state.model, wire->node, wire->port));
    if (!through) return false;
    Node node = node_of_type(state.document(), type);
    const std::string id = node.id;
    const ImVec2 at = free_place(state, wire->middle() - ImVec2(64, 40), node, &type);
    Document document = add_node(state.document(), std::move(node), at.x, at.y);
    const Connection place{wire->from, wire->node, wire->port};
    commit_new(state, type, id, insert_in_wire(document, place, id, *through));
    return true;
}

}  // namespace

Node node_of_type(const Document& document, const NodeType& type) {
    Node node;
    node.id = free_id(document, type.id);
    node.type = type.id;
    node.version = static_cast<int>(type.version);
    return node;
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
    Node node = node_of_type(state.document(), type);
    const std::string id = node.id;
    const ImVec2 place = free_place(state, at, node, &type);
    Document document = add_node(state.document(), std::move(node), place.x, place.y);
    if (const Port* port = wire.kind == Gesture::Kind::wire ? port_for(type, wire) : nullptr)
        document = wire.from_output ? connect(document, wire.from, id, port->name)
                                    : with_wire(document, {id, port->name}, wire.node, wire.port);
    commit_new(state, type, id, std::move(document));
}

void add_node_to_selection(State& state, const NodeType& type, ImVec2 at) {
    if (add_in_wire(state, type)) return;
    Node node = node_of_type(state.document(), type);
    const std::string id = node.id;
    Document document = add_node(state.document(), std::move(node));
    float right = 0;
    const Card* first = nullptr;
    for (const Card* card : givers(state)) {
        const Pin& pin = card->pins.front();
        const Port* port = free_port(type, *document.find(id), pin.type);
        if (!port) continue;
        document = connect(document, {card->id, pin.port}, id, port->name);
        right = first ? std::max(right, card->at.x + card->size.x) : card->at.x + card->size.x;
        if (!first) first = card;
    }
    const ImVec2 place =
        free_place(state, first ? ImVec2(right + 64, first->at.y) : at, *document.find(id), &type);
    commit_new(state, type, id, move_node(document, id, place.x, place.y));
}

}  // namespace wrinkle::editor
