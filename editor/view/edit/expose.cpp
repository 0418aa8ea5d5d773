#include "editor/model/document/expose.h"

#include <algorithm>

#include "editor/model/words.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/edit/edits.h"

namespace wrinkle::editor {

PortOfNode pointed_port(const State& state) {
    const Hit& hit = state.hovered;
    if (!hit.on_card(state.layout)) return {};
    const Card& card = state.layout.cards[hit.card];
    const Node* node = state.document().find(card.id);
    if (!node || !card.type || card.reroute) return {};
    if (hit.kind == Hit::Kind::field && hit.part < card.fields.size())
        return {node->id, &card.type->ports[card.fields[hit.part].index]};
    if (hit.kind != Hit::Kind::pin || hit.part >= card.pins.size()) return {};
    const Pin& pin = card.pins[hit.part];
    return {node->id, pin.output ? nullptr : input_port(card.type, pin.port)};
}

std::vector<PortOfNode> exposable_of_selected(const State& state) {
    std::vector<PortOfNode> found;
    for (const std::string& id : state.view.selected) {
        const Node* node = state.document().find(id);
        const NodeType* type = node ? state.type_of(id) : nullptr;
        if (!type) continue;
        for (const Port* port : exposable_ports(*node, *type))
            found.push_back({id, port});
    }
    return found;
}

void expose_ports(State& state, const std::vector<PortOfNode>& ports) {
    Document document = state.document();
    std::string last;
    for (const auto& [id, port] : ports) {
        const Node* node = document.find(id);
        if (!node) return;
        state.status = why_not_exposed(*node, *port);
        if (!state.status.empty()) return;
        Exposed exposed = expose(document, *node, *port);
        document = std::move(exposed.document);
        last = id + "." + port->name + " as " + exposed.input;
    }
    state.inputs_panel.shown = true;
    state.commit("Expose " + (ports.size() == 1 ? last : counted(ports.size(), "value")),
                 std::move(document));
}

std::string_view no_exposable(const State& state) {
    const auto is_known = [&](const std::string& id) { return state.type_of(id) != nullptr; };
    if (pointed_port(state).port || std::ranges::any_of(state.view.selected, is_known)) return {};
    return "Point at a value, or select nodes.";
}

void expose_pointed(State& state) {
    if (const PortOfNode pointed = pointed_port(state); pointed.port)
        return expose_ports(state, {pointed});
    const auto ports = exposable_of_selected(state);
    if (ports.size() == 1) return expose_ports(state, ports);
    if (ports.empty()) {
        state.status = "Every value of the selected nodes has a wire.";
    } else if (const Card* card = state.layout.find(ports.front().node)) {
        open_popup(state, *card, nullptr, Popup::Kind::expose);
    }
}

}  // namespace wrinkle::editor
