#include "gpu/bands.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace wrinkle::gpu {
namespace {

int even(int rows) {
    return std::max(rows / 2 * 2, 2);
}

}  // namespace

Bands::Bands(const BandOptions& options) : options_(options) {
    const bool timed = options.milliseconds > 0;
    rows_ = std::min(even(timed ? options.height / 8 : options.height + 1), options.most_rows);
}

std::optional<Band> Bands::next() {
    using Clock = std::chrono::steady_clock;
    if (start_) {
        glFinish();
        const std::chrono::duration<double, std::milli> took = Clock::now() - *start_;
        took_ += took.count();
        const double aim = options_.milliseconds;
        const double fit = aim / std::max(took.count(), aim / 4);
        rows_ = std::min(even(static_cast<int>(rows_ * fit)), options_.most_rows);
    }
    if (low_ >= options_.height) return std::nullopt;
    if (options_.before) options_.before();
    if (options_.milliseconds > 0) start_ = Clock::now();
    const int above = low_ % options_.most_rows;
    const int left = std::min(options_.most_rows - above, options_.height - low_);
    const Band band{low_, std::min(rows_, left), low_ - above};
    low_ += band.rows;
    return band;
}

}  // namespace wrinkle::gpu
