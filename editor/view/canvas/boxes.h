// Frames and notes on the canvas: extent, hit test, contents of a frame. Lengths in canvas units.
#pragma once

#include <optional>

#include "editor/model/document/boxes.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

inline constexpr float title_height = 36, box_corner = 8;

Extent extent_of(const Box& box);  // as stored
// The extent as drawn, including the drag in progress.
Extent extent_of(const CanvasState& canvas, const BoxId& id, const Box& box);

// Hit test for the title, an edge or a corner of a frame, and for any point of a note. Returns a
// hit with `card` = Hit::no_card and `part` = index in all_boxes(); std::nullopt if no box is hit.
std::optional<Hit> pick_box(const State& state, ImVec2 mouse);

void name_boxes(State& state);  // "frame:ID" is its title, "note:ID" the entire note

// Adds the frame itself and the cards and boxes that lie entirely inside it.
void add_contents(const State& state, const BoxId& frame, std::set<std::string>& cards,
                  std::set<BoxId>& boxes);

}  // namespace wrinkle::editor
