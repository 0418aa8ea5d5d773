// Wires from card to card, without choosing pins.
#pragma once

#include <optional>

#include "editor/view/state.h"

namespace wrinkle::editor {

// The best-fitting pins: equal types before convertible ones, free inputs before connected ones,
// then equal names, then pin order. Indices of pins of the two cards.
struct PinPair {
    size_t out = 0, in = 0;
};
std::optional<PinPair> best_pins(const Card& from, const Card& to, bool free_only = false);

// The wire of a drag between two cards: forward, else backward to a free input.
struct LazyWire {
    const Card* from = nullptr;
    const Card* to = nullptr;
    PinPair pins;
};
std::optional<LazyWire> lazy_wire(const State& state, const Card& first, const Card& last);

}  // namespace wrinkle::editor
