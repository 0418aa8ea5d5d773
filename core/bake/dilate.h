// Dilation: fills texels next to islands from the nearest covered texel. Part of bake_rows().
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wrinkle {

// Ring buffer of image rows; each row has one plane per lane.
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

// Writes rows [first, last) to `values` and `covered`, in the layout of BakedRows. Precondition:
// the window holds rows [low, high), including the `reach` rows around the output that exist. Runs
// on several threads.
void dilate(const RowWindow& window, uint32_t first, uint32_t last, uint32_t low, uint32_t high,
            uint32_t reach, float* values, uint8_t* covered);

}  // namespace wrinkle
