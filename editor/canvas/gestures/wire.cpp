#include "editor/canvas/canvas.h"
#include "editor/canvas/gestures/gestures.h"
#include "editor/document/edits.h"

namespace wrinkle::editor {

void begin_wire(State& state, const Card& card, const Pin& pin) {
    begin_gesture(state, Gesture::Kind::wire);
    Gesture& wire = state.gesture;
    const std::string id = card.kind == Card::Kind::outputs ? "" : card.id;
    if (!pin.output) {
        wire.node = id;
        wire.port = pin.port;
    }
    wire.from_output = pin.output;
    wire.type = pin.type;
    if (pin.output) {
        wire.from = {id, pin.port};
    } else if (const auto link = link_at(state.document(), id, pin.port)) {
        wire.from_output = wire.taken = true;
        wire.from = *link;
        wire.type = state.model.type_of(*link).value_or(pin.type);
    }
    find_loops(state.document(), wire);
}

// A wire that is lifted off its input leaves the document with the first motion.
void lift_wire(State& state) {
    Gesture& g = state.gesture;
    if (!g.taken) return;
    state.commit("Disconnect " + g.from.text(), without_wire(state.document(), g.node, g.port),
                 g.merge);
    find_loops(state.document(), g);
}

void drop_wire(State& state) {
    const Gesture wire = state.gesture;
    const Hit hit = pick(state, ImGui::GetIO().MousePos);
    if (hit.kind == Hit::Kind::pin) {
        const Card& card = state.layout.cards[hit.card];
        connect_wire(state, wire, card, card.pins[hit.part]);
    } else if (wire.moved && !wire.taken &&
               (hit.kind == Hit::Kind::nothing || hit.kind == Hit::Kind::wire)) {
        open_palette(state, ImGui::GetIO().MousePos, wire);
    }
}

bool wire_fits(const State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    return why_not(state, wire, card, pin).empty();
}

void connect_wire(State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    const std::string id = card.kind == Card::Kind::outputs ? "" : card.id;
    if (wire.taken && id == wire.node && pin.port == wire.port && !pin.output) {
        if (wire.moved) state.history.cancel(wire.merge);
        return;
    }
    if (!wire.moved) return;
    if (const std::string why = why_not(state, wire, card, pin); !why.empty()) {
        if (wire.taken) state.history.cancel(wire.merge);
        state.status = why;
        return;
    }
    const Link from = wire.from_output ? wire.from : Link{card.id, pin.port};
    const std::string to = wire.from_output ? id : wire.node;
    const std::string port = wire.from_output ? pin.port : wire.port;
    state.commit("Connect " + from.text() + " to " + (to.empty() ? "output" : to) + "." + port,
                 with_wire(state.document(), from, to, port), wire.merge);
}

}  // namespace wrinkle::editor
