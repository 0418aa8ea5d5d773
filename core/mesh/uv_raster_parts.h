// Whole numbers that ownership of texels is computed in. Part of mesh/uv_raster.h.
#pragma once

#include <algorithm>
#include <cstdint>

namespace wrinkle {

constexpr int64_t units = 256;        // of a texel
constexpr uint32_t marked = ~0U - 1;  // of a slot that is not numbered yet

constexpr int64_t floor_div(int64_t a, int64_t b) {  // b > 0
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// The texel that a number of units lies in.
constexpr int64_t texel_at(int64_t place) {
    static_assert(units == 256);
    return place >> 8;
}

// One edge of a counter-clockwise triangle, from (ax, ay) by (dx, dy). What lies to its left is
// inside; of the edge itself, where it runs downwards or to the right.
struct RasterEdge {
    int64_t ax, ay, dx, dy;

    int64_t least() const { return dy < 0 || (dy == 0 && dx > 0) ? 0 : 1; }
    bool has_inside(int64_t x, int64_t y) const { return dx * (y - ay) - dy * (x - ax) >= least(); }
};

struct Interval {
    int64_t low, high;  // both included
    bool empty() const { return low > high; }
};

template <class Triangle>
RasterEdge edge_of(const Triangle& t, size_t k) {
    const size_t next = (k + 1) % 3;
    return {t.x[k], t.y[k], int64_t{t.x[next]} - t.x[k], int64_t{t.y[next]} - t.y[k]};
}

// The texels from `first` on, `count` of them, that `box` meets.
template <class Box>
Interval texels_met(const Box& box, uint32_t first, uint32_t count) {
    return {std::max<int64_t>(box.low, first),
            std::min<int64_t>(box.high, int64_t{first} + count - 1)};
}

}  // namespace wrinkle
