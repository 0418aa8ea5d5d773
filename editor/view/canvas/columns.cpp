#include "editor/view/canvas/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

// Range of y of a wire's curve between x = left and x = right; low.y > high.y if they do not
// overlap.
Extent heights_between(ImVec2 start, ImVec2 end, float left, float right) {
    constexpr int pieces = 32;
    constexpr float none = std::numeric_limits<float>::infinity();
    Extent range{{left, none}, {right, -none}};
    if (std::min(start.x, end.x) > right || std::max(start.x, end.x) < left) return range;
    const Curve curve = wire_curve(start, end, 1);
    ImVec2 last = curve.a;
    for (int i = 1; i <= pieces; ++i) {
        const ImVec2 next = curve.at(static_cast<float>(i) / pieces);
        if (std::max(last.x, next.x) >= left && std::min(last.x, next.x) <= right) {
            range.low.y = std::min({range.low.y, last.y, next.y});
            range.high.y = std::max({range.high.y, last.y, next.y});
        }
        last = next;
    }
    return range;
}

constexpr float lane = 12;  // clearance above and below a wire
constexpr int sweeps = 24, enough_sweeps = 6, repairs = 6;

// A line where it passes a column, with the range of y that it occupies there.
struct Lane {
    size_t from, to;
    float top, bottom;
};

class Placer {
public:
    Placer(std::vector<ColumnBox>& boxes, const std::vector<ColumnLine>& lines)
        : boxes_(boxes), lines_(lines), lines_of_(boxes.size()) {
        size_t count = 0;
        for (const ColumnBox& box : boxes)
            count = std::max(count, box.column + 1);
        columns_.resize(count);
        crossing_.resize(count);
        for (size_t i = 0; i < boxes.size(); ++i)
            columns_[boxes[i].column].push_back(i);
        for (size_t i = 0; i < lines.size(); ++i) {
            lines_of_[lines[i].from].push_back(i);
            lines_of_[lines[i].to].push_back(i);
            for (size_t c = boxes[lines[i].from].column; c <= boxes[lines[i].to].column; ++c)
                crossing_[c].push_back(i);
        }
        set_columns();
    }

    void run() {
        for (std::vector<size_t>& column : columns_) {
            std::ranges::stable_sort(column, {}, [&](size_t i) { return boxes_[i].at.y; });
            stack(column);
        }
        std::vector<ColumnBox> best;
        std::pair<size_t, float> least{std::numeric_limits<size_t>::max(), 0};
        const auto keep_best = [&] {
            const auto cost = this->cost();
            if (best.empty() || cost < least) least = cost, best = boxes_;
            return cost.first > 0;
        };
        for (int i = 0; i < sweeps; ++i) {
            sweep(i);
            for (int k = 0; keep_best() && k < repairs; ++k)
                repair(k);
            if (least.first == 0 && i >= enough_sweeps) break;
        }
        boxes_ = std::move(best);
    }

private:
    void set_columns() {
        float left = 0;
        for (const std::vector<size_t>& column : columns_) {
            float width = 0;
            for (const size_t i : column)
                width = std::max(width, boxes_[i].size.x);
            for (const size_t i : column)
                boxes_[i].at.x = left;
            left_.push_back(left);
            width_.push_back(width);
            left += width > 0 ? grid_up(width) + column_gap : 0;
        }
    }
    void stack(const std::vector<size_t>& column) {
        float top = 0;
        for (const size_t i : column) {
            boxes_[i].at.y = top;
            top += grid_up(boxes_[i].size.y) + row_gap;
        }
    }

    ImVec2 start_of(const ColumnLine& line) const {
        const ColumnBox& box = boxes_[line.from];
        return box.at + ImVec2(box.size.x, line.from_y);
    }
    ImVec2 end_of(const ColumnLine& line) const {
        return boxes_[line.to].at + ImVec2(0, line.to_y);
    }

    void sweep(int number) {
        const bool right = number % 2 == 0;
        for (size_t k = 0; k < columns_.size(); ++k) {
            const size_t c = right ? k : columns_.size() - 1 - k;
            // The first two sweeps determine the order, one from each side.
            place(c, number < 2, right);
        }
    }

    // Moves only boxes that hide a wire.
    void repair(int number) {
        for (size_t k = 0; k < columns_.size(); ++k) {
            const size_t c = number % 2 == 0 ? k : columns_.size() - 1 - k;
            std::vector<float> present(boxes_.size(), 0);
            for (const size_t i : columns_[c])
                present[i] = boxes_[i].at.y;
            put(c, present);
        }
    }

    // Returns the top at which the box's wires are horizontal on average.
    float wanted_top(size_t box, bool one_side, bool left_side) const {
        float sum = 0, count = 0;
        for (const size_t l : lines_of_[box]) {
            const ColumnLine& line = lines_[l];
            const bool ends_here = line.to == box;
            if (one_side && ends_here != left_side) continue;
            sum += ends_here ? start_of(line).y - line.to_y : end_of(line).y - line.from_y;
            ++count;
        }
        return count > 0 ? sum / count : boxes_[box].at.y;
    }

    void place(size_t c, bool one_side, bool left_side) {
        std::vector<size_t>& column = columns_[c];
        std::map<size_t, std::pair<float, float>> groups;  // sum of middles, count
        std::vector<float> wanted(boxes_.size(), 0);
        const auto middle = [&](size_t i) { return wanted[i] + boxes_[i].size.y / 2; };
        for (const size_t i : column) {
            wanted[i] = wanted_top(i, one_side, left_side);
            auto& [sum, count] = groups[boxes_[i].group];
            sum += middle(i), ++count;
        }
        const auto key = [&](size_t i) {
            const auto& [sum, count] = groups[boxes_[i].group];
            return std::pair(boxes_[i].group == 0 ? middle(i) : sum / count, middle(i));
        };
        std::ranges::stable_sort(column, {}, key);
        spread(column, wanted);
        put(c, wanted);
    }

    // Sets the tops of a column from the top down, in the gaps between the wires.
    void put(size_t c, const std::vector<float>& wanted) {
        const std::vector<Lane> lanes = lanes_in(c);
        float top = -std::numeric_limits<float>::infinity();
        for (const size_t i : columns_[c]) {
            boxes_[i].at.y = free_top(i, std::max(wanted[i], top), top, lanes);
            top = boxes_[i].at.y + grid_up(boxes_[i].size.y) + row_gap;
        }
    }

    // Separates overlapping boxes with the least squared movement (pool adjacent violators).
    void spread(const std::vector<size_t>& column, std::vector<float>& wanted) const {
        struct Block {
            float sum = 0;     // tops minus the heights above
            size_t count = 0;  // boxes
            float top() const { return sum / static_cast<float>(count); }
        };
        std::vector<Block> blocks;
        float above = 0;
        for (const size_t i : column) {
            blocks.push_back({wanted[i] - above, 1});
            above += grid_up(boxes_[i].size.y) + row_gap;
            while (blocks.size() > 1 && blocks[blocks.size() - 2].top() > blocks.back().top()) {
                const Block last = blocks.back();
                blocks.pop_back();
                blocks.back().sum += last.sum, blocks.back().count += last.count;
            }
        }
        above = 0;
        auto box = column.begin();
        for (const Block& block : blocks)
            for (size_t n = 0; n < block.count; ++n, ++box) {
                wanted[*box] = block.top() + above;
                above += grid_up(boxes_[*box].size.y) + row_gap;
            }
    }

    std::vector<Lane> lanes_in(size_t c) const {
        std::vector<Lane> lanes;
        for (const size_t l : crossing_[c]) {
            const ColumnLine& line = lines_[l];
            const Extent range =
                heights_between(start_of(line), end_of(line), left_[c], left_[c] + width_[c]);
            if (range.low.y <= range.high.y)
                lanes.push_back({line.from, line.to, range.low.y - lane, range.high.y + lane});
        }
        std::ranges::sort(lanes, {}, &Lane::top);
        return lanes;
    }

    // Returns the top >= `least` nearest to `wanted` at which the box overlaps no lane of other
    // boxes; `wanted`, rounded to the grid, if there is none.
    float free_top(size_t box, float wanted, float least, const std::vector<Lane>& lanes) const {
        const float tall = boxes_[box].size.y;
        const auto is_free = [&](float top) {
            return std::ranges::none_of(lanes, [&](const Lane& each) {
                return each.from != box && each.to != box && each.top < top + tall &&
                       each.bottom > top;
            });
        };
        const auto on_grid = [](float at) { return std::round(at / grid) * grid; };
        wanted = std::max(on_grid(wanted), std::isinf(least) ? on_grid(wanted) : grid_up(least));
        if (is_free(wanted)) return wanted;
        float best = wanted, nearest = std::numeric_limits<float>::infinity();
        const auto offer = [&](float top) {
            const float away = std::fabs(top - wanted);
            if (top < least || away >= nearest || !is_free(top)) return;
            nearest = away;
            best = top;
        };
        for (const Lane& each : lanes) {
            offer(grid_up(each.bottom));
            offer(std::floor((each.top - tall) / grid) * grid);
        }
        return best;
    }

    // Returns the number of hidden wires and the sum of the height differences of all wires.
    std::pair<size_t, float> cost() const {
        size_t hidden = 0;
        float rise = 0;
        for (const ColumnLine& line : lines_) {
            const ImVec2 start = start_of(line), end = end_of(line);
            rise += std::fabs(end.y - start.y);
            bool is_hidden = false;
            for (size_t c = boxes_[line.from].column; c <= boxes_[line.to].column; ++c)
                for (const size_t i : columns_[c])
                    is_hidden |= i != line.from && i != line.to && hides(boxes_[i], start, end);
            hidden += is_hidden;
        }
        return {hidden, rise};
    }
    static bool hides(const ColumnBox& box, ImVec2 start, ImVec2 end) {
        if (box.at.y > std::max(start.y, end.y) || box.at.y + box.size.y < std::min(start.y, end.y))
            return false;
        const Extent range = heights_between(start, end, box.at.x, box.at.x + box.size.x);
        return range.low.y <= range.high.y && range.low.y < box.at.y + box.size.y &&
               range.high.y > box.at.y;
    }

    std::vector<ColumnBox>& boxes_;
    const std::vector<ColumnLine>& lines_;
    std::vector<std::vector<size_t>> lines_of_, columns_, crossing_;
    std::vector<float> left_, width_;
};

}  // namespace

void place_in_columns(std::vector<ColumnBox>& boxes, const std::vector<ColumnLine>& lines) {
    if (boxes.empty()) return;
    Placer(boxes, lines).run();
    float top = boxes.front().at.y;
    for (const ColumnBox& box : boxes)
        top = std::min(top, box.at.y);
    for (ColumnBox& box : boxes)
        box.at.y -= top;
}

}  // namespace wrinkle::editor
