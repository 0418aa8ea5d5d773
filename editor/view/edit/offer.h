// Proposes nodes that convert between two types: they take the one and return the other.
#pragma once

#include <vector>

#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns at most `most` choices, the best first; empty if no single node converts.
std::vector<Offer::Choice> between(const Registry& registry, PortType from, PortType to,
                                   size_t most = 3);

// Opens the offer at the pointer for a wire that was dropped at a pin of another type.
void offer_between(State& state, const Gesture& wire, const Card& card, const Pin& pin);
// Inserts the chosen node between the two ends in one undo step.
void accept_offer(State& state, size_t choice);

}  // namespace wrinkle::editor
