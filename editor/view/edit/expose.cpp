#include "editor/model/document/expose.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/edit/edits.h"

namespace wrinkle::editor {
namespace {

// The node and the port of the field or input under the pointer; nullptr if there is none.
std::pair<const Node*, const Port*> pointed_port(const State& state) {
    const Hit& hit = state.hovered;
    if (!hit.on_card(state.layout)) return {};
    const Card& card = state.layout.cards[hit.card];
    const Node* node = state.document().find(card.id);
    if (!node || !card.type || card.reroute) return {};
    if (hit.kind == Hit::Kind::field && hit.part < card.fields.size())
        return {node, &card.type->ports[card.fields[hit.part].index]};
    if (hit.kind != Hit::Kind::pin || hit.part >= card.pins.size()) return {};
    const Pin& pin = card.pins[hit.part];
    return {node, pin.output ? nullptr : input_port(card.type, pin.port)};
}

}  // namespace

void expose_port(State& state, const std::string& id, const Port& port) {
    const Node* node = state.document().find(id);
    if (!node) return;
    state.status = why_not_exposed(*node, port);
    if (!state.status.empty()) return;
    Exposed exposed = expose(state.document(), *node, port);
    state.inputs_panel.shown = true;
    state.commit("Expose " + id + "." + port.name + " as " + exposed.input,
                 std::move(exposed.document));
}

std::string_view no_exposable(const State& state) {
    const Node* node = selected_node(state);
    if (pointed_port(state).second || (node && state.type_of(node->id))) return {};
    return "Point at a value, or select one node.";
}

void expose_pointed(State& state) {
    if (const auto [node, port] = pointed_port(state); port)
        return expose_port(state, node->id, *port);
    const Node* node = selected_node(state);
    const NodeType* type = node ? state.type_of(node->id) : nullptr;
    const Card* card = node ? state.layout.find(node->id) : nullptr;
    if (!type || !card) return;
    const auto ports = exposable_ports(*node, *type);
    if (ports.empty()) state.status = node->id + " has no value without a wire.";
    if (ports.size() == 1) return expose_port(state, node->id, *ports[0]);
    if (ports.size() > 1) open_popup(state, *card, nullptr, Popup::Kind::expose);
}

}  // namespace wrinkle::editor
