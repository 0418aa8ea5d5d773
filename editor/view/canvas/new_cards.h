// Positions of new cards: near the requested position, without covering another card. New cards are
// drawn on top and scrolled into view. Lengths in canvas units.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "editor/view/state.h"

namespace wrinkle::editor {

Extent around(const std::vector<Extent>& extents);  // the smallest that contains all

// Returns an offset close to `by` that separates each extent of `moving` from all `fixed`; on
// the grid. More than 16 extents move as their bounding box. If no offset in range is free, returns
// one below all `fixed`. O(fixed * moving) per offset, at most 70,000 offsets.
ImVec2 free_shift(const std::vector<Extent>& fixed, std::vector<Extent> moving, ImVec2 by);
// Extents of all cards except `except`.
std::vector<Extent> card_extents(const CanvasState& canvas,
                                 const std::set<std::string>& except = {});

// Returns an offset near `by`, on the grid, at which cards at `places` and the boxes of `source`
// overlap no card, and the boxes overlap no other box.
ImVec2 free_offset(const State& state, const std::vector<Extent>& places, const Document& source,
                   const std::set<BoxId>& boxes, ImVec2 by);

// The size of the card of a node that has none yet.
ImVec2 new_card_size(const State& state, const Node& node, const NodeType* type);
// Returns the position near `at` at which the node's card covers no other, nor a node of `document`
// that has no card yet; `except` are cards about to be removed.
ImVec2 free_place(const State& state, const Document& document, ImVec2 at, const Node& node,
                  const NodeType* type, const std::set<std::string>& except = {});

// Returns the document with the current positions stored for cards without one: the automatic
// layout would move them as soon as another card has a position.
Document settled(const State& state, const Document& document);

// Selects new nodes and raises them above all other cards; the next frame scrolls them into view.
void show_new(CanvasState& canvas, const std::set<std::string>& ids);
void reveal_new(CanvasState& canvas);  // after the layout update
// Called before the canvas changes its size: in a smaller one, selected cards stay in sight.
void keep_in_sight(CanvasState& canvas, ImVec2 extent);

}  // namespace wrinkle::editor
