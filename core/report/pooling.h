// Pooling: numbers that summarize a map of errors.
//
// Quantiles are those of NVIDIA's FLIP: percentiles by nearest rank; a weighted quantile p is the
// first value, in ascending order, at which the running sum exceeds p times the total. It shows the
// size of the errors that there are, where a percentile also counts pixels without any.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace wrinkle::report {

class Pooling {
public:
    // O(n log n). Precondition: one channel, at least one pixel, no negative or NaN values.
    explicit Pooling(const Image& map);

    double mean() const { return total_ / static_cast<double>(sorted_.size()); }
    double root_mean_square() const;
    float min() const { return sorted_.front(); }
    float max() const { return sorted_.back(); }
    float percentile(double percent) const;          // 0 < percent <= 100
    float weighted_quantile(double fraction) const;  // 0 <= fraction < 1; 0.5: weighted median
    uint64_t count_above(float limit) const;         // pixels
    uint64_t count() const { return sorted_.size(); }

    // Position of the first maximum, in reading order from the top left.
    uint32_t max_x() const { return max_x_; }
    uint32_t max_y() const { return max_y_; }

private:
    std::vector<float> sorted_;
    double total_ = 0;
    uint32_t max_x_ = 0, max_y_ = 0;
};

}  // namespace wrinkle::report
