// Places of new cards: near where they are wanted, over no other card; then above all others and in
// sight. Lengths in canvas units.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "editor/state.h"

namespace wrinkle::editor {

// How far the things at `moving` go, about as far as `by`, so that each is clear of all `fixed`; on
// the grid. Of many things it is their common box that is clear. O(fixed * moving) for each place
// that is tried, 70,000 of them at most; where all are taken, below everything.
ImVec2 free_shift(const std::vector<Extent>& fixed, std::vector<Extent> moving, ImVec2 by);
// Of the cards without those of `except`.
std::vector<Extent> card_extents(const State& state, const std::set<std::string>& except = {});

// Where the node's card covers no other, near `at`; those of `except` are about to go.
ImVec2 free_place(const State& state, ImVec2 at, const Node& node, const NodeType* type,
                  const std::set<std::string>& except = {});

// The document with the places that cards without one have now: they would go elsewhere as soon as
// another card has one.
Document settled(const State& state, const Document& document);

// Selects nodes that a step has just made, above all other cards; the next frame brings them in
// sight.
void show_new(State& state, const std::set<std::string>& ids);
void reveal_new(State& state);  // after the layout is up to date

}  // namespace wrinkle::editor
