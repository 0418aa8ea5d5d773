// Frames and notes on the canvas: where they are, what of them lies under the pointer, what stands
// in a frame. Lengths in canvas units.
#pragma once

#include <optional>
#include <vector>

#include "editor/state.h"

namespace wrinkle::editor {

inline constexpr float title_height = 36, box_corner = 8;

const Box* find_box(const Document& document, const BoxId& id);
Document with_box(const Document& document, bool note, Box box);
Document without_box(const Document& document, const BoxId& id);
std::string free_box_id(const Document& document, bool note);

// As it is drawn, with the drag under way.
Extent extent_of(const State& state, const BoxId& id, const Box& box);

// All boxes from the lowest to the topmost: frames, then notes.
std::vector<BoxId> all_boxes(const Document& document);

// A title, an edge or a corner of a frame, or any place on a note. A hit's `card` is no card's
// index, its `part` the index among all boxes.
std::optional<Hit> pick_box(const State& state, ImVec2 mouse);

void name_boxes(State& state);  // "frame:ID" is its title, "note:ID" the whole note

// What a frame takes along: the cards and boxes that lie in it whole.
void add_contents(const State& state, const BoxId& frame, std::set<std::string>& cards,
                  std::set<BoxId>& boxes);

}  // namespace wrinkle::editor
