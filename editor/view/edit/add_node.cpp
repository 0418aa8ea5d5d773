// Adds nodes: loose, at the end of a wire, in a wire, after the selection.
#include <algorithm>

#include "base/text.h"
#include "editor/model/document/wiring.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/edit/layer.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

// Returns the first port of an equal type, else the first that converts; nullptr if none fits. An
// input must be free if there is a node.
const Port* port_for(const NodeType& type, PortType other, bool input, const Node* node = nullptr) {
    const Port* found = nullptr;
    for (const Port& port : type.ports) {
        if (input ? !port.is_value() : port.kind != Port::Kind::output) continue;
        if (node && node->find(port.name)) continue;
        if (port.type == other) return &port;
        const bool fits = input ? converts(other, port.type) : converts(port.type, other);
        if (fits && !found) found = &port;
    }
    return found;
}

// Connects the first normal or material of a graph without outputs to the output of that type.
Document with_first_output(const NodeType& type, const std::string& id, Document document) {
    const auto output = std::ranges::find(type.ports, Port::Kind::output, &Port::kind);
    if (!document.outputs.empty() || output == type.ports.end()) return document;
    if (output->type != PortType::normal_ && output->type != PortType::material_) return document;
    return with_wire(document, {id, output->name}, "", std::string(name_of(output->type)));
}

// `loose`: the node was not added at the end of a wire.
void commit_new(State& state, const NodeType& type, const std::string& id, Document document,
                bool loose) {
    document = with_first_output(type, id, std::move(document));
    const bool first = state.document().nodes.empty();
    state.commit("Add " + type.title, settled(state, document));
    show_new(state, {id});
    // The surface is put to the left of the first node, and the outputs to its right.
    if (first && loose) {
        state.view.surface_at.reset();
        state.view.outputs_at.reset();
        state.view.fitted = false;
    }
}

constexpr float gap = 64;  // between a card and the next one to its right

// Moves the card of the outputs to the right of a new card that ends at `right`, if it is to the
// right of the new card's source, which ends at `left`.
void move_outputs_after(State& state, float left, float right) {
    const Card* outputs = state.layout.find(Card::outputs_id, Card::Kind::outputs);
    if (!outputs || outputs->at.x < left || outputs->at.x >= right + gap) return;
    const ImVec2 by = free_shift(card_extents(state, {outputs->id}), {outputs->extent()},
                                 {right + gap - outputs->at.x, 0});
    push_borders(state, {state.view.surface_at, outputs->at + by});
}

// The outputs of the graph that read `from` read the node's output of that type, if it has one.
Document with_outputs_moved(const Link& from, PortType given, const std::string& id,
                            const NodeType& type, Document document) {
    const auto is_given = [&](const Port& port) {
        return port.kind == Port::Kind::output && port.type == given;
    };
    const auto port = std::ranges::find_if(type.ports, is_given);
    if (port == type.ports.end()) return document;
    const Table<Output> outputs = document.outputs;
    for (const Output& output : outputs)
        if (link_at(document, "", output.name) == from)
            document = with_wire(document, {id, port->name}, "", output.name);
    return document;
}

// Returns the selected cards with a typed first output, from top to bottom.
std::vector<const Card*> givers(const State& state) {
    std::vector<const Card*> found = selected_cards(state);
    std::erase_if(found, [](const Card* card) {
        return card->pins.empty() || !card->pins.front().output || !card->pins.front().known;
    });
    std::ranges::sort(found, {},
                      [](const Card* card) { return std::pair(card->at.y, card->at.x); });
    return found;
}

// Inserts the node in the selected wire, or lays its bump over the one on the wire; returns false
// if there is none or neither fits.
bool add_in_wire(State& state, const NodeType& type) {
    if (!state.view.selected_wire) return false;
    const Wire* wire = state.layout.wire_to(*state.view.selected_wire);
    if (!wire || !wire->known) return false;
    const auto through = passage(
        type, wire->from_type, wanted_ends(state.model, state.document(), wire->node, wire->port));
    const Port* bump = bump_of(type);
    if (!through && !bump) return false;
    Node node = node_of_type(state.document(), type);
    const std::string id = node.id;
    const ImVec2 at =
        free_place(state, state.document(), wire->middle() - ImVec2(64, 40), node, &type);
    const Document document = add_node(state.document(), std::move(node), at.x, at.y);
    std::string why;
    const std::optional<Document> wired =
        through ? insert_in_wire(document, *wire, id, *through)
                : with_bump_on_wire(state, document, *wire, {id, bump->name}, at, why);
    if (!wired) return false;
    commit_new(state, type, id, *wired, false);
    return true;
}

constexpr int far_off = 20;

// Lower is better: same types, the main input, few other inputs.
int distance(const NodeType& type, const Passage& through, PortType from, PortType to) {
    int away = 0, inputs = 0;
    for (const Port& port : type.ports) {
        const bool is_output = port.kind == Port::Kind::output;
        if (port.is_value()) {
            if (port.name == through.in) away += 100 * (port.type != from) + 20 * (inputs > 0);
            ++inputs;
        }
        if (is_output && port.name == through.out) away += 100 * (port.type != to);
    }
    return away + inputs;
}

}  // namespace

Node node_of_type(const Document& document, const NodeType& type) {
    Node node;
    node.type = type.id;
    const auto file = node.subgraph();
    node.id = free_id(document, file ? identifier(fs::path(*file).stem().string()) : type.id);
    if (!file) node.version = static_cast<int>(type.version);
    return node;
}

bool type_fits(const NodeType& type, const Gesture& wire) {
    return wire.kind != Gesture::Kind::wire || port_for(type, wire.type, wire.from_output);
}

bool type_matches(const NodeType& type, const Gesture& wire) {
    if (wire.kind != Gesture::Kind::wire) return true;
    const Port* port = port_for(type, wire.type, wire.from_output);
    return port && port->type == wire.type;
}

void add_node_of_type(State& state, const NodeType& type, ImVec2 at, const Gesture& wire) {
    Node node = node_of_type(state.document(), type);
    const std::string id = node.id;
    const ImVec2 place = free_place(state, state.document(), at, node, &type);
    Document document = add_node(state.document(), std::move(node), place.x, place.y);
    if (const Port* port = wire.kind == Gesture::Kind::wire
                               ? port_for(type, wire.type, wire.from_output)
                               : nullptr)
        document = wire.from_output ? connect(document, wire.from, id, port->name)
                                    : with_wire(document, {id, port->name}, wire.node, wire.port);
    commit_new(state, type, id, std::move(document), wire.kind != Gesture::Kind::wire);
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
        const Port* port = port_for(type, pin.type, true, document.find(id));
        if (!port) continue;
        document = connect(document, {card->id, pin.port}, id, port->name);
        if (!first)
            document =
                with_outputs_moved({card->id, pin.port}, pin.type, id, type, std::move(document));
        right = first ? std::max(right, card->at.x + card->size.x) : card->at.x + card->size.x;
        if (!first) first = card;
    }
    std::set<std::string> moving;
    if (first) moving.insert(Card::outputs_id);
    const ImVec2 place =
        free_place(state, state.document(), first ? ImVec2(right + gap, first->at.y) : at,
                   *document.find(id), &type, moving);
    const ImVec2 size = new_card_size(state, *document.find(id), &type);
    commit_new(state, type, id, move_node(document, id, place.x, place.y), true);
    if (first) move_outputs_after(state, first->extent().high.x, place.x + size.x);
}

std::vector<Offer::Choice> between(const Registry& registry, PortType from,
                                   const std::vector<PortType>& ends, size_t most) {
    std::vector<std::pair<int, Offer::Choice>> found;
    for (const NodeType& type : registry.list()) {
        if (type.family == "comparison") continue;
        if (const auto through = passage(type, from, ends))
            found.emplace_back(distance(type, *through, from, ends.empty() ? from : ends.front()),
                               Offer::Choice{&type, through->in, through->out});
    }
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Offer::Choice> choices;
    for (size_t i = 0; i < std::min(most, found.size()); ++i)
        if (found[i].first < found[0].first + far_off) choices.push_back(found[i].second);
    return choices;
}

void offer_between(State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    if (pin.output == wire.from_output || !pin.known) return;
    Offer offer;
    offer.connection = connection_at(wire, card, pin);
    const auto given = state.model.type_of(offer.connection.from);
    const std::vector<PortType> ends =
        wanted_ends(state.model, state.document(), offer.connection.node, offer.connection.port);
    if (!given || converts(*given, ends) || wire.loops.contains(card.link_id())) return;
    if (wire.taken) offer.lifted = Link{wire.node, wire.port};
    offer.choices = between(*state.registry, *given, ends);
    offer.why = state.status;
    if (!offer.choices.empty()) offer.why = offer.why.substr(0, offer.why.find(';')) + ".";
    offer.at = ImGui::GetIO().MousePos;
    offer.open = offer.opening = true;
    state.offer = std::move(offer);
}

void accept_offer(State& state, size_t choice) {
    const Offer offer = std::move(state.offer);
    state.offer = {};
    if (choice >= offer.choices.size()) return;
    const Offer::Choice& chosen = offer.choices[choice];
    Node node = node_of_type(state.document(), *chosen.type);
    const std::string id = node.id;
    const ImVec2 wanted = to_canvas(state.view, offer.at) - ImVec2(224, 40);
    const ImVec2 at = free_place(state, state.document(), wanted, node, chosen.type);
    Document document = state.document();
    if (offer.lifted)
        document = cut_wires(state.model, document,
                             {{offer.connection.from, offer.lifted->node, offer.lifted->port}});
    document = add_node(document, std::move(node), at.x, at.y);
    state.commit(
        "Insert " + chosen.type->title,
        insert_in_wire(settled(state, document), offer.connection, id, {chosen.in, chosen.out}));
    show_new(state, {id});
}

}  // namespace wrinkle::editor
