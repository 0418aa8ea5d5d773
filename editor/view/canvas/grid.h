// The canvas's grid, in canvas units.
#pragma once

#include <cmath>

namespace wrinkle::editor {

inline constexpr float grid = 8;
// Gaps between cards in columns.
inline constexpr float row_gap = 32, column_gap = 64;

inline float grid_up(float length) {
    return std::ceil(length / grid) * grid;
}

}  // namespace wrinkle::editor
