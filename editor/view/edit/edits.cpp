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

Connection connection_at(const Gesture& wire, const Card& card, const Pin& pin) {
    if (wire.from_output) return {wire.from, card.link_id(), pin.port};
    return {{card.id, pin.port}, wire.node, wire.port};
}

void commit_connection(State& state, const Connection& to, const std::string& merge) {
    state.commit("Connect " + to.from.text() + " to " + (to.node.empty() ? "output" : to.node) +
                     "." + to.port,
                 with_wire(state.document(), to.from, to.node, to.port), merge);
}

std::string why_not(const State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    if (pin.output == wire.from_output)
        return pin.output ? "a wire ends at an input" : "a wire begins at an output";
    const auto [from, to, port] = connection_at(wire, card, pin);
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

void open_palette(Dialogs& dialogs, ImVec2 at, const Gesture& wire) {
    dialogs.palette = {};
    dialogs.palette.open = dialogs.palette.opening = true;
    dialogs.palette.at = at;
    dialogs.palette.wire = wire;
}

}  // namespace wrinkle::editor
