#include <cmath>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// Screen pixels at any zoom: 12, plus a margin because pointer positions are integers.
constexpr float reach = 13.5F;

// The best pin so far: a fitting pin before any other, then the nearer one.
struct Aim {
    Hit hit;
    bool fits = false;
    float distance = 0;

    void offer(Hit pin, bool pin_fits, float away) {
        if (hit.kind == Hit::Kind::pin &&
            (fits > pin_fits || (fits == pin_fits && distance <= away)))
            return;
        *this = {pin, pin_fits, away};
    }
};

bool is_over(const Card& card, ImVec2 at, float margin) {
    const ImVec2 around(margin, margin);
    return Extent{card.at - around, card.at + card.size + around}.contains(at);
}

Aim pin_in_reach(const State& state, ImVec2 mouse) {
    Aim aim;
    const ImVec2 at = to_canvas(state.view, mouse);
    for (size_t i = 0; i < state.layout.cards.size(); ++i) {
        const Card& card = state.layout.cards[i];
        if (!is_over(card, at, reach / state.view.zoom)) continue;
        for (size_t k = 0; k < card.pins.size(); ++k) {
            if (card.pins[k].output == state.gesture.from_output) continue;
            const ImVec2 away = to_screen(state.view, pin_at(card, card.pins[k])) - mouse;
            const float distance = std::hypot(away.x, away.y);
            if (distance > reach) continue;
            aim.offer({Hit::Kind::pin, i, k}, wire_fits(state, state.gesture, card, card.pins[k]),
                      distance);
        }
    }
    return aim;
}

// Returns the pin of the row at `at`. Between rows, and if rows are too small to hit, returns a
// fitting pin, free inputs first.
Aim pin_of_card(const State& state, size_t index, ImVec2 at) {
    Aim aim;
    const Card& card = state.layout.cards[index];
    for (size_t k = 0; k < card.pins.size(); ++k) {
        const Pin& pin = card.pins[k];
        if (pin.output == state.gesture.from_output) continue;
        const bool fits = wire_fits(state, state.gesture, card, pin);
        const float away = std::fabs(at.y - card.at.y - pin.y);
        const bool in_row = away < row_height / 2;
        if (in_row && (fits || state.view.zoom >= detail_zoom))
            return {{Hit::Kind::pin, index, k}, fits, 0};
        if (fits) aim.offer({Hit::Kind::pin, index, k}, !pin.output && !pin.connected, away);
    }
    return aim;
}

bool is_own(const CanvasState& canvas, const Card& card) {
    const Gesture& wire = canvas.gesture;
    return card.kind == Card::Kind::node &&
           card.id == (wire.from_output ? wire.from.node : wire.node);
}

int score(const Pin& out, const Pin& in, bool reroute) {
    if (reroute) return 0;  // a reroute takes the type of its source
    if (!out.known || !in.known || !converts(out.type, in.type)) return -1;
    return 8 * (out.type == in.type) + 6 * !in.connected + (out.port == in.port);
}

std::optional<LazyWire> best_wire(const Card& from, const Card& to, bool free_only) {
    std::optional<LazyWire> best;
    int most = -1;
    for (const Pin& out : from.pins)
        for (const Pin& in : to.pins) {
            if (!out.output || in.output || (free_only && in.connected)) continue;
            const int points = score(out, in, to.reroute);
            if (points <= most) continue;
            most = points;
            best = LazyWire{&from, &to, &out, &in};
        }
    return best;
}

bool is_possible(const State& state, const LazyWire& wire) {
    const bool nodes = wire.to->kind == Card::Kind::node && wire.from->kind == Card::Kind::node;
    if (nodes && would_cycle(state.document(), {wire.from->id, ""}, wire.to->id)) return false;
    return wire_is_legal(state.model, state.document(), wire.out->type, wire.to->link_id(),
                         wire.in->port);
}

}  // namespace

Hit snap_wire(const State& state, ImVec2 mouse) {
    const Aim near = pin_in_reach(state, mouse);
    if (near.fits) return near.hit;
    const ImVec2 at = to_canvas(state.view, mouse);
    for (size_t i = state.layout.cards.size(); i-- > 0;) {
        const Card& card = state.layout.cards[i];
        if (!is_over(card, at, 0)) continue;
        const Aim aim = is_own(state, card) ? near : pin_of_card(state, i, at);
        if (aim.hit.kind == Hit::Kind::pin) return aim.hit;
        return near.hit.kind == Hit::Kind::pin ? near.hit : Hit{Hit::Kind::card, i, 0};
    }
    return near.hit;
}

void begin_wire(State& state, const Card& card, const Pin& pin) {
    begin_gesture(state, Gesture::Kind::wire);
    Gesture& wire = state.gesture;
    wire.from_output = pin.output;
    wire.type = pin.type;
    if (pin.output) {
        wire.from = {card.id, pin.port};
        return find_loops(state.document(), wire);
    }
    wire.node = card.link_id();
    wire.port = pin.port;
    if (const auto link = link_at(state.document(), wire.node, wire.port)) {
        wire.from_output = wire.taken = true;
        wire.from = *link;
        wire.type = state.model.type_of(*link).value_or(pin.type);
    }
    find_loops(state.document(), wire);
}

// Disconnects a wire that is detached from its input; called at the first motion.
void lift_wire(State& state) {
    Gesture& g = state.gesture;
    if (!g.taken) return;
    state.commit("Disconnect " + g.from.text(),
                 cut_wires(state.model, state.document(), {{g.from, g.node, g.port}}), g.merge);
    find_loops(state.document(), g);
}

void drop_wire(State& state) {
    const Gesture wire = state.gesture;
    const Hit hit = snap_wire(state, ImGui::GetIO().MousePos);
    if (hit.kind == Hit::Kind::pin) {
        const Card& card = state.layout.cards[hit.card];
        connect_wire(state, wire, card, card.pins[hit.part]);
    } else if (wire.moved && !wire.taken && hit.kind == Hit::Kind::nothing) {
        open_palette(state, ImGui::GetIO().MousePos, wire);
    }
}

bool wire_fits(const State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    if (pin.output == wire.from_output || !pin.known) return false;
    const std::string id = card.link_id();
    if (!id.empty() && wire.loops.contains(id)) return false;
    if (wire.from_output)
        return wire_is_legal(state.model, state.document(), wire.type, id, pin.port);
    return wire_is_legal(state.model, state.document(), pin.type, wire.node, wire.port);
}

void connect_wire(State& state, const Gesture& wire, const Card& card, const Pin& pin) {
    if (wire.taken && card.link_id() == wire.node && pin.port == wire.port && !pin.output) {
        if (wire.moved) state.history.cancel(wire.merge);
        return;
    }
    if (!wire.moved) return;
    if (const std::string why = why_not(state, wire, card, pin); !why.empty()) {
        if (wire.taken) state.history.cancel(wire.merge);
        state.status = why;
        offer_between(state, wire, card, pin);
        return;
    }
    commit_connection(state, connection_at(wire, card, pin), wire.merge);
}

std::optional<LazyWire> lazy_wire(const State& state, const Card& first, const Card& last) {
    for (const auto& wire : {best_wire(first, last, false), best_wire(last, first, true)})
        if (wire && is_possible(state, *wire)) return wire;
    return std::nullopt;
}

void drop_lazy(State& state) {
    const Hit hit = state.hovered;
    if (!state.gesture.moved || !hit.on_card(state.layout) || hit.card == state.gesture.card)
        return;
    const Card &first = state.layout.cards[state.gesture.card],
               &last = state.layout.cards[hit.card];
    const auto wire = lazy_wire(state, first, last);
    if (!wire) {
        state.status = "No output of " + first.id + " fits an input of " + last.id + ".";
        return;
    }
    commit_connection(state,
                      {{wire->from->id, wire->out->port}, wire->to->link_id(), wire->in->port});
}

}  // namespace wrinkle::editor
