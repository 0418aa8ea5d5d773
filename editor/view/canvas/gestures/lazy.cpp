#include "editor/view/canvas/lazy.h"

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/edit/edits.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

int score(const Pin& out, const Pin& in, bool reroute) {
    if (reroute) return 0;  // a reroute takes the type of its source
    if (!out.known || !in.known || !converts(out.type, in.type)) return -1;
    return 8 * (out.type == in.type) + 6 * !in.connected + (out.port == in.port);
}

bool is_possible(const State& state, const LazyWire& wire) {
    const bool nodes = wire.to->kind == Card::Kind::node && wire.from->kind == Card::Kind::node;
    if (nodes && would_cycle(state.document(), {wire.from->id, ""}, wire.to->id)) return false;
    return wire_is_legal(state.model, state.document(), wire.from->pins[wire.pins.out].type,
                         wire.to->link_id(), wire.to->pins[wire.pins.in].port);
}

}  // namespace

std::optional<PinPair> best_pins(const Card& from, const Card& to, bool free_only) {
    std::optional<PinPair> best;
    int most = -1;
    for (size_t o = 0; o < from.pins.size(); ++o)
        for (size_t i = 0; i < to.pins.size(); ++i) {
            if (!from.pins[o].output || to.pins[i].output) continue;
            if (free_only && to.pins[i].connected) continue;
            const int points = score(from.pins[o], to.pins[i], to.reroute);
            if (points <= most) continue;
            most = points;
            best = PinPair{o, i};
        }
    return best;
}

std::optional<LazyWire> lazy_wire(const State& state, const Card& first, const Card& last) {
    if (const auto pins = best_pins(first, last))
        if (const LazyWire wire{&first, &last, *pins}; is_possible(state, wire)) return wire;
    if (const auto pins = best_pins(last, first, true))
        if (const LazyWire wire{&last, &first, *pins}; is_possible(state, wire)) return wire;
    return std::nullopt;
}

void drop_lazy(State& state) {
    const Hit hit = state.hovered;
    if (!hit.on_card(state.layout) || hit.card == state.gesture.card) return;
    const Card &first = state.layout.cards[state.gesture.card],
               &last = state.layout.cards[hit.card];
    const auto wire = lazy_wire(state, first, last);
    if (!wire) {
        state.status = "No output of " + first.id + " fits an input of " + last.id + ".";
        return;
    }
    commit_connection(state, {{wire->from->id, wire->from->pins[wire->pins.out].port},
                              wire->to->link_id(),
                              wire->to->pins[wire->pins.in].port});
}

}  // namespace wrinkle::editor
