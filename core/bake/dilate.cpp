#include "bake/dilate.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace wrinkle {
namespace {

constexpr int16_t nothing_near = INT16_MAX;

// Returns for each texel of the rows [first, last) the signed distance to the nearest covered texel
// in its column; negative is up. First pass of a separable Euclidean distance transform.
std::vector<int16_t> column_distances(const RowWindow& window, uint32_t first, uint32_t last,
                                      uint32_t low, uint32_t high, uint32_t reach) {
    std::vector<int16_t> result(size_t{window.width} * (last - first), nothing_near);
    const auto visit_row = [&](uint32_t r, uint32_t begin, std::vector<int32_t>& nearest) {
        const uint8_t* covered = window.covered.data() + window.covered_at(r) + begin;
        const auto row = static_cast<int32_t>(r), limit = static_cast<int32_t>(reach);
        int32_t* at = nearest.data();
        for (size_t x = 0; x < nearest.size(); ++x)
            at[x] = covered[x] ? row : at[x];
        if (r < first || r >= last) return;
        int16_t* distances = result.data() + size_t{r - first} * window.width + begin;
        for (size_t x = 0; x < nearest.size(); ++x) {
            const int32_t found = at[x] - row, old = distances[x];
            const int32_t max_found = std::min(limit, std::abs(old) - 1);
            distances[x] = static_cast<int16_t>(std::abs(found) <= max_found ? found : old);
        }
    };
    const auto measure = [&](const tbb::blocked_range<uint32_t>& columns) {
        constexpr int32_t far = 1 << 24;
        std::vector<int32_t> nearest(columns.size(), -far);
        for (uint32_t r = std::max(low, first - std::min(first, reach)); r < last; ++r)
            visit_row(r, columns.begin(), nearest);
        std::ranges::fill(nearest, far);
        for (uint32_t r = std::min(high, last + reach); r-- > first;)
            visit_row(r, columns.begin(), nearest);
    };
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, window.width, 256), measure);
    return result;
}

struct Nearest {
    int64_t x = -1;
    int16_t distance = 0;
};

// Visits columns by increasing distance, as long as one can be nearer than the best.
Nearest nearest_of(const int16_t* distances, int64_t width, int64_t x, int64_t reach) {
    Nearest best;
    int64_t best_square = reach * reach + 1;
    const auto visit = [&](int64_t column, int64_t aside) {
        if (column < 0 || column >= width || distances[column] == nothing_near) return;
        const int64_t square = aside * aside + int64_t{distances[column]} * distances[column];
        if (square >= best_square) return;
        best_square = square;
        best = {column, distances[column]};
    };
    for (int64_t aside = 0; aside <= reach && aside * aside < best_square; ++aside) {
        visit(x - aside, aside);
        visit(x + aside, aside);
    }
    return best;
}

// One output row: the lanes of its texels, 0 for texels without a value.
struct RowOutput {
    float* values;
    uint8_t* covered;
};

void copy_row(const RowWindow& window, uint32_t r, const RowOutput& to) {
    const uint8_t* covered = window.covered.data() + window.covered_at(r);
    std::copy_n(covered, window.width, to.covered);
    for (size_t lane = 0; lane < window.lanes; ++lane) {
        const float* from = window.values.data() + window.lane_at(r, lane);
        float* out = to.values + lane * window.width;
        for (uint32_t x = 0; x < window.width; ++x)
            out[x] = covered[x] ? from[x] : 0;
    }
}

// `distances` holds the distances in the columns of this row.
void fill_gaps(const RowWindow& window, uint32_t r, const int16_t* distances, uint32_t reach,
               const RowOutput& to) {
    const bool empty = std::all_of(distances, distances + window.width,
                                   [](int16_t distance) { return distance == nothing_near; });
    for (uint32_t x = 0; x < window.width && !empty; ++x) {
        if (distances[x] == 0) continue;
        const Nearest nearest = nearest_of(distances, window.width, x, reach);
        if (nearest.x < 0) continue;
        to.covered[x] = 2;
        const auto row = static_cast<uint32_t>(int64_t{r} + nearest.distance);
        for (size_t lane = 0; lane < window.lanes; ++lane)
            to.values[lane * window.width + x] =
                window.values[window.lane_at(row, lane) + static_cast<size_t>(nearest.x)];
    }
}

bool are_covered(const RowWindow& window, uint32_t first, uint32_t last) {
    for (uint32_t r = first; r < last; ++r)
        if (std::memchr(&window.covered[window.covered_at(r)], 0, window.width)) return false;
    return true;
}

}  // namespace

void dilate(const RowWindow& window, uint32_t first, uint32_t last, uint32_t low, uint32_t high,
            uint32_t reach, float* values, uint8_t* covered) {
    std::vector<int16_t> distances;
    if (reach > 0 && !are_covered(window, first, last))
        distances = column_distances(window, first, last, low, high, reach);
    tbb::parallel_for(first, last, [&](uint32_t r) {
        const size_t texels = size_t{r - first} * window.width;
        const RowOutput to = {values + texels * window.lanes, covered + texels};
        copy_row(window, r, to);
        if (!distances.empty()) fill_gaps(window, r, distances.data() + texels, reach, to);
    });
}

}  // namespace wrinkle
