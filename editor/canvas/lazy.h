// A wire from card to card without aiming at pins.
#pragma once

#include <optional>

#include "editor/state.h"

namespace wrinkle::editor {

// The ends that fit best: equal types before types that convert, free inputs before taken ones,
// equal names, then the order of the pins. Indices of pins of the two cards.
struct PinPair {
    size_t out = 0, in = 0;
};
std::optional<PinPair> best_pins(const Card& from, const Card& to, bool free_only = false);

// The wire of a drag from one card to the other: forth, else back to an input that is free.
struct LazyWire {
    const Card* from = nullptr;
    const Card* to = nullptr;
    PinPair pins;
};
std::optional<LazyWire> lazy_wire(const State& state, const Card& first, const Card& last);

}  // namespace wrinkle::editor
