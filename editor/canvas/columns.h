// What Tidy places, without what it is: boxes, and lines between their sides. Lengths in canvas
// units. For editor/canvas/tidy.cpp.
#pragma once

#include <imgui.h>

#include <vector>

#include "editor/canvas/card.h"

namespace wrinkle::editor {

struct ColumnBox {
    ImVec2 size{0, 0};
    size_t column = 0;
    size_t group = 0;  // those of one group are together in a column; 0: none
    ImVec2 at{0, 0};   // in: its present height says the order; out: its place
};
// From the right side of a box to the left side of one in a later column.
struct ColumnLine {
    size_t from = 0, to = 0;     // boxes
    float from_y = 0, to_y = 0;  // of its ends, below the boxes' corners
};

// From (0, 0) on to the right and down.
void place_in_columns(std::vector<ColumnBox>& boxes, const std::vector<ColumnLine>& lines);

// The heights that the curve of a wire runs through between two places; low.y > high.y for none.
Extent heights_between(ImVec2 start, ImVec2 end, float left, float right);

}  // namespace wrinkle::editor
