// The nearest legal way from one type to another: nodes that take the one and make the other.
#pragma once

#include <vector>

#include "editor/state.h"

namespace wrinkle::editor {

// The best first, at most `most`; empty when no single node does it.
std::vector<Offer::Choice> between(const Registry& registry, PortType from, PortType to,
                                   size_t most = 3);

// Opens the offer at the pointer for a wire that was dropped where its type does not fit.
void offer_between(State& state, const Gesture& wire, const Card& card, const Pin& pin);
// Puts the chosen node between the two ends, in one step.
void accept_offer(State& state, size_t choice);

}  // namespace wrinkle::editor
