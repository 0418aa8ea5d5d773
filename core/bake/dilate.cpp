#include "bake/dilate.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>

namespace wrinkle {
namespace {

constexpr int16_t nothing_near = INT16_MAX;

// Of each texel of the rows, the way to the nearest covered one in its column: up is negative.
class ColumnDistances {
public:
    ColumnDistances(const RowWindow& window, uint32_t first, uint32_t last, uint32_t low,
                    uint32_t high, uint32_t reach)
        : window_(window),
          first_(first),
          last_(last),
          low_(low),
          high_(high),
          reach_(static_cast<int64_t>(reach)),
          ways_(size_t{window.width} * (last - first), nothing_near) {
        tbb::parallel_for(tbb::blocked_range<uint32_t>(0, window.width, 256),
                          [&](const auto& columns) { measure(columns.begin(), columns.end()); });
    }

    const int16_t* row(uint32_t row) const {
        return ways_.data() + size_t{row - first_} * window_.width;
    }

private:
    void measure(uint32_t begin, uint32_t end) {
        const int64_t far = int64_t{1} << 40;
        std::vector<int64_t> nearest(end - begin, -far);
        const int64_t top = std::max<int64_t>(low_, int64_t{first_} - reach_);
        for (int64_t r = top; r < last_; ++r)
            look(static_cast<uint32_t>(r), begin, end, nearest);
        std::fill(nearest.begin(), nearest.end(), far);
        const int64_t bottom = std::min<int64_t>(high_, int64_t{last_} + reach_);
        for (int64_t r = bottom - 1; r >= first_; --r)
            look(static_cast<uint32_t>(r), begin, end, nearest);
    }

    void look(uint32_t r, uint32_t begin, uint32_t end, std::vector<int64_t>& nearest) {
        const uint8_t* covered = window_.covered.data() + window_.texel(0, r);
        for (uint32_t x = begin; x < end; ++x) {
            int64_t& at = nearest[x - begin];
            if (covered[x]) at = r;
            if (r < first_ || r >= last_) continue;
            int16_t& way = ways_[size_t{r - first_} * window_.width + x];
            const int64_t found = at - int64_t{r};
            if (std::abs(found) <= reach_ && std::abs(found) < std::abs(way))
                way = static_cast<int16_t>(found);
        }
    }

    const RowWindow& window_;
    uint32_t first_, last_, low_, high_;
    int64_t reach_;
    std::vector<int16_t> ways_;
};

struct Nearest {
    int64_t x = -1;
    int16_t way = 0;
};

// Columns are looked at from the nearest on, as long as one may be nearer than the best.
Nearest nearest_of(const int16_t* ways, int64_t width, int64_t x, int64_t reach) {
    Nearest best;
    int64_t least = reach * reach + 1;
    const auto look = [&](int64_t column, int64_t aside) {
        if (column < 0 || column >= width || ways[column] == nothing_near) return;
        const int64_t square = aside * aside + int64_t{ways[column]} * ways[column];
        if (square >= least) return;
        least = square;
        best = {column, ways[column]};
    };
    for (int64_t aside = 0; aside <= reach && aside * aside < least; ++aside) {
        look(x - aside, aside);
        look(x + aside, aside);
    }
    return best;
}

}  // namespace

void dilate(const RowWindow& window, uint32_t first, uint32_t last, uint32_t low, uint32_t high,
            uint32_t reach, float* values, uint8_t* covered) {
    const ColumnDistances distances(window, first, last, low, high, reach);
    const auto fill_row = [&](uint32_t r) {
        const int16_t* ways = distances.row(r);
        const bool empty =
            std::all_of(ways, ways + window.width, [](int16_t way) { return way == nothing_near; });
        float* to = values + size_t{r - first} * window.width * window.lanes;
        uint8_t* seen = covered + size_t{r - first} * window.width;
        for (uint32_t x = 0; x < window.width; ++x, to += window.lanes) {
            Nearest nearest{x, 0};
            if (ways[x] != 0)
                nearest = empty ? Nearest{} : nearest_of(ways, window.width, x, reach);
            seen[x] = nearest.x < 0 ? 0 : ways[x] == 0 ? 1 : 2;
            if (nearest.x < 0) {
                std::fill_n(to, window.lanes, 0.0F);
                continue;
            }
            const auto row = static_cast<uint32_t>(int64_t{r} + nearest.way);
            const size_t from = window.texel(static_cast<uint32_t>(nearest.x), row);
            std::copy_n(window.values.data() + from * window.lanes, window.lanes, to);
        }
    };
    tbb::parallel_for(first, last, fill_row);
}

}  // namespace wrinkle
