#include "editor/view/edit/edits.h"

#include "base/text.h"
#include "editor/model/document/field.h"
#include "editor/view/canvas/layout.h"
#include "graph/edit.h"

namespace wrinkle::editor {

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
