// Fixed-point arithmetic for texel ownership; v is upwards. Part of mesh/uv_raster.h.
#pragma once

#include <cstdint>

namespace wrinkle {

constexpr int64_t units = 256;        // per texel
constexpr uint32_t marked = ~0U - 1;  // in Coverage::slots: edge texel without an index yet

constexpr int64_t floor_div(int64_t a, int64_t b) {  // b > 0
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

// Returns the texel that contains a coordinate in units.
constexpr int64_t texel_at(int64_t coordinate) {
    static_assert(units == 256);
    return coordinate >> 8;
}

// Edge of a counter-clockwise triangle from (ax, ay) to (ax + dx, ay + dy), in units. Points to its
// left are inside; points on it are inside if it runs downwards, or horizontally to the right, so
// that a point on a shared edge is inside exactly one of the two triangles.
struct RasterEdge {
    int64_t ax, ay, dx, dy;

    int64_t min_inside() const { return dy < 0 || (dy == 0 && dx > 0) ? 0 : 1; }
    bool has_inside(int64_t x, int64_t y) const {
        return dx * (y - ay) - dy * (x - ax) >= min_inside();
    }
};

template <class Triangle>
RasterEdge edge_of(const Triangle& t, size_t k) {
    const size_t next = (k + 1) % 3;
    return {t.x[k], t.y[k], int64_t{t.x[next]} - t.x[k], int64_t{t.y[next]} - t.y[k]};
}

}  // namespace wrinkle
