#include "report/pooling.h"

#include <algorithm>
#include <cmath>

namespace wrinkle::report {

Pooling::Pooling(const Image& map) : sorted_(map.data) {
    std::sort(sorted_.begin(), sorted_.end());
    for (const float value : sorted_)
        total_ += value;
    for (uint32_t y = map.height; y-- > 0;) {
        const float* row = map.texel(0, y);
        const float* found = std::find(row, row + map.width, max());
        if (found == row + map.width) continue;
        max_x_ = static_cast<uint32_t>(found - row);
        max_y_ = map.height - 1 - y;
        return;
    }
}

double Pooling::root_mean_square() const {
    double sum = 0;
    for (const float value : sorted_)
        sum += double{value} * value;
    return std::sqrt(sum / static_cast<double>(sorted_.size()));
}

float Pooling::percentile(double percent) const {
    const double rank = std::ceil(percent / 100 * static_cast<double>(sorted_.size()));
    return sorted_[std::min(sorted_.size(), std::max(size_t{1}, static_cast<size_t>(rank))) - 1];
}

float Pooling::weighted_quantile(double fraction) const {
    double sum = 0;
    for (const float value : sorted_) {
        sum += value;
        if (sum > fraction * total_) return value;
    }
    return max();
}

uint64_t Pooling::count_above(float limit) const {
    const auto first = std::upper_bound(sorted_.begin(), sorted_.end(), limit);
    return static_cast<uint64_t>(sorted_.end() - first);
}

}  // namespace wrinkle::report
