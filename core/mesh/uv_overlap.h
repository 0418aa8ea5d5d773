// Detects overlaps in uv layouts. The time does not depend on how many triangles cover a texel.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace wrinkle {

// Set of the texels of a rectangle that fewer than two triangles cover so far. The caller closes a
// texel at its second triangle, so each texel is visited at most twice. At most 2^32 - 1 texels.
// Union-find with path halving: O(log n) amortised per call.
class OpenTexels {
public:
    void open_all(size_t count) {
        next_.resize(count + 1);
        std::iota(next_.begin(), next_.end(), 0U);
    }
    // Returns the first open texel at or after `texel`; the texel count if there is none.
    size_t first_open(size_t texel) {
        auto at = static_cast<uint32_t>(texel);
        while (next_[at] != at)
            at = next_[at] = next_[next_[at]];
        return at;
    }
    void close(size_t texel) { next_[texel] = static_cast<uint32_t>(texel + 1); }

private:
    std::vector<uint32_t> next_;  // next_[i] == i if texel i is open
};

// Calls drop(index) for each triangle with the same corners, in any order, as two earlier ones: the
// first owns the texels, the second suffices to detect the overlap. O(n log n).
template <class Triangle, class Drop>
void each_third_repeat(const std::vector<Triangle>& triangles, Drop drop) {
    using Corners = std::array<std::pair<int32_t, int32_t>, 3>;
    std::vector<std::pair<Corners, uint32_t>> sorted;
    sorted.reserve(triangles.size());
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        Corners corners{{{t.x[0], t.y[0]}, {t.x[1], t.y[1]}, {t.x[2], t.y[2]}}};
        std::ranges::sort(corners);
        sorted.emplace_back(corners, i);
    }
    std::ranges::sort(sorted);
    for (size_t i = 2; i < sorted.size(); ++i)
        if (sorted[i].first == sorted[i - 2].first) drop(sorted[i].second);
}

}  // namespace wrinkle
