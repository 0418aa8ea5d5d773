// The canvas's grid, and a layout of boxes in columns with lines between their sides, independent
// of cards and wires. Lengths in canvas units.
#pragma once

#include <imgui.h>

#include <vector>

#include <cmath>
#include "editor/view/canvas/card.h"

namespace wrinkle::editor {

inline constexpr float grid = 8;
inline constexpr float row_gap = 32, column_gap = 64;  // between cards in columns

inline float grid_up(float length) {
    return std::ceil(length / grid) * grid;
}

struct ColumnBox {
    ImVec2 size{0, 0};
    size_t column = 0;
    size_t group = 0;  // boxes of one group are adjacent in a column; 0: none
    ImVec2 at{0, 0};   // in: y gives the initial order; out: position
};
// A line from the right side of a box to the left side of a box in a later column.
struct ColumnLine {
    size_t from = 0, to = 0;     // boxes
    float from_y = 0, to_y = 0;  // y of the ends, relative to the boxes' corners
};

// Sets `at` of all boxes, in columns from (0, 0) to the right and down.
void place_in_columns(std::vector<ColumnBox>& boxes, const std::vector<ColumnLine>& lines);

}  // namespace wrinkle::editor
