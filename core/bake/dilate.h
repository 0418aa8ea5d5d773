// Texels beside islands, filled from the nearest texel of one. Part of bake_rows().
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wrinkle {

// Rows of a picture that are at hand, each as a plane of every lane.
struct RowWindow {
    uint32_t width = 0, capacity = 0;
    size_t lanes = 0;
    std::vector<float> values;
    std::vector<uint8_t> covered;

    RowWindow(uint32_t width, uint32_t capacity, size_t lanes)
        : width(width),
          capacity(capacity),
          lanes(lanes),
          values(size_t{width} * capacity * lanes),
          covered(size_t{width} * capacity) {}
    size_t lane_at(uint32_t row, size_t lane) const {
        return (size_t{row % capacity} * lanes + lane) * width;
    }
    size_t covered_at(uint32_t row) const { return size_t{row % capacity} * width; }
};

// Rows first to last, without last, into `values` and `covered` one after the other, as BakedRows
// has them. Those from low to high, without high, are at hand: as far as `reach` looks. May run on
// many threads.
void dilate(const RowWindow& window, uint32_t first, uint32_t last, uint32_t low, uint32_t high,
            uint32_t reach, float* values, uint8_t* covered);

}  // namespace wrinkle
