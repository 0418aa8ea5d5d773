// Splits a drawing into bands of rows, from the bottom, each finished before the next begins: other
// contexts of the driver run in between, and buffers are only as high as a band.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

namespace wrinkle::gpu {

struct Band {
    int low = 0, rows = 0;
    int origin = 0;  // first row of the target that the buffers hold, a multiple of most_rows
};

struct BandOptions {
    int height = 0;                // rows of the target
    int most_rows = 0;             // rows of the buffers, even
    double milliseconds = 0;       // aimed at per band; 0: as few bands as possible
    std::function<void()> before;  // called before each band, may block; may be empty
};

// Bands have an even number of rows, so that the 2 x 2 pixels of screen differentials are the same
// as in one drawing.
class Bands {
public:
    explicit Bands(const BandOptions& options);

    // Finishes the previous band and returns the next one; std::nullopt after the last. Its
    // duration sets the height of the next one.
    std::optional<Band> next();

    double milliseconds() const { return took_; }  // total of the bands so far, if an aim was given

private:
    BandOptions options_;
    int low_ = 0, rows_ = 0;
    double took_ = 0;
    std::optional<std::chrono::steady_clock::time_point> start_;
};

}  // namespace wrinkle::gpu
