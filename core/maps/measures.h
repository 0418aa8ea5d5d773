// Statistics for lint, computed in one pass over the rows of an image, from the top. Memory is
// O(width): the last three and the first two rows are retained. Sums are double, row by row, on one
// thread, so the results are reproducible.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"
#include "maps/map.h"

namespace wrinkle::maps {

inline constexpr double u8_step = 1.0 / 255;  // step of 8-bit values

// Statistics of images with three channels; vectors are 2t - 1. Black texels (not baked) count only
// in `empty`.
struct VectorMeasures {
    double empty = 0;     // share of black texels
    double unit = 0;      // share of texels of length 1 within 0.1
    double downward = 0;  // share with z below -0.1
    double gray = 0;      // share with channels equal within 2.5 / 255
    std::array<double, 3> mean = {};
    double blue_spread = 0;  // range of blue
    double signed_z = 0;     // rms of blue - (1 + z) / 2, with z from red and green
    double unsigned_z = 0;   // rms of blue - z
    double between_z = 0;    // rms of (1 + z) / 2 - z: the separation of these two encodings
};

// Curl of the slopes (su, sv) of a normal map that is read as `gl`, clamped to +-4. Derivatives of
// slopes are computed by sobel_row(). The slopes of a height have no curl: d(su)/dv = d(sv)/du.
struct CurlMeasures {
    double gl = 0;           // rms of d(su)/dv - d(sv)/du: small if green points up
    double dx = 0;           // rms of d(su)/dv + d(sv)/du: small if green points down
    double correlation = 0;  // between d(su)/dv and d(sv)/du, -1 to 1; 0 without slopes
    // Shares of the regions (8 by 8 over the image) with a correlation above 0.5, and below -0.5,
    // weighted by the size of their derivatives. 0 for images of less than 4096 texels, where
    // regions are too small.
    double regions_gl = 0, regions_dx = 0;
};

// Differences between neighbours in one integer channel.
struct StepMeasures {
    double still = 0;         // share of neighbours (to the right, above) that are equal
    double one = 0;           // share that differs by one level
    size_t levels = 0;        // number of distinct values
    bool eight_bits = false;  // a deeper file that holds only 8-bit values
};

// Mean step across the border and between inner neighbours, over the first `channels` channels.
struct SeamMeasures {
    double border = 0;
    double inside = 0;  // 99th percentile of the inner columns (or rows)
};

// Statistics of an image as islands on one background. Background texels are black or flat
// (normals), or 0 or the middle (heights), within 2.5 / 255.
struct IslandMeasures {
    double background = 0;  // share of texels
    double shore = 0;       // mean step between neighbours of which one is background
    double inside = 0;      // mean step between neighbours outside the background
    double plain = 0;       // share of texels in 8 by 8 squares of only background
};

// The accumulators below take the rows of an image in order, from the top. Precondition of their
// results: all rows were added. `texels`: number of texels of the image.
class VectorSums {
public:
    void add(const float* row, uint32_t width, uint32_t channels);
    VectorMeasures measures(double texels) const;

private:
    VectorMeasures sums_;
    double lowest_blue_ = 2, highest_blue_ = -1;
    size_t empty_ = 0, unit_ = 0, downward_ = 0, gray_ = 0;
};

// Curl statistics in a window of three rows.
class CurlSums {
public:
    CurlSums(uint32_t width, uint32_t height, Wrap wrap);
    void add(const float* row, uint32_t stride, uint32_t channels);  // row of a normal map
    CurlMeasures measures() const;

private:
    struct SlopeRow {
        std::vector<float> du, dv;
    };
    struct Sums {
        double uu = 0, vv = 0, uv = 0;
    };
    static constexpr uint32_t regions = 8;
    using RegionSums = std::array<std::array<Sums, regions>, regions>;  // [row][column]
    void add(const SlopeRow& above, const SlopeRow& here, const SlopeRow& below, uint32_t y,
             RegionSums& sums) const;

    uint32_t width_, height_;
    Wrap wrap_;
    uint32_t rows_ = 0;
    std::array<SlopeRow, 3> last_;  // row i at i % 3
    SlopeRow first_, second_;
    RegionSums sums_;
};

// Sum of the offsets from 127.5, in steps of 1/255, of the texels that are not flat. A flat texel
// has 127 or 128 in both red and green.
struct OffsetSums {
    double red = 0, green = 0;
    size_t tilted = 0;  // number of these texels

    void add(const float* row, uint32_t width, uint32_t channels);
};

class StepSums {
public:
    explicit StepSums(PixelType type) : type_(type), seen_(65536) {}
    void add(const float* row, uint32_t width, uint32_t channels, uint32_t channel);
    StepMeasures measures() const;

private:
    PixelType type_;
    std::vector<uint8_t> seen_;
    std::vector<int> above_, here_;
    size_t still_ = 0, one_ = 0, pairs_ = 0;
};

// Steps in one channel, along both axes.
class SeamSums {
public:
    explicit SeamSums(uint32_t width) : across_u_(width) {}
    void add(const float* row, uint32_t channels, uint32_t channel);
    // Sums from each column, or row, to the next; the last entry crosses the border.
    const std::vector<double>& across_u() const { return across_u_; }
    std::vector<double> across_v() const;

private:
    std::vector<double> across_u_, across_v_;
    std::vector<float> first_, above_, here_;
};

class IslandSums {
public:
    enum class Background : uint8_t { normals, zero, middle };
    explicit IslandSums(Background background) : background_(background) {}
    void add(const float* row, uint32_t width, uint32_t channels);
    IslandMeasures measures(double texels) const;

private:
    struct Row {
        std::vector<float> red, green;  // for heights, both hold the height
        std::vector<uint8_t> background;
    };
    bool is_background(const float* texel) const;
    void compare(const Row& a, size_t first_a, const Row& b, size_t first_b, size_t count);

    Background background_;
    Row above_, here_;
    std::vector<uint8_t> plain_;  // per square of the current 8 rows: only background so far
    size_t rows_ = 0, plain_count_ = 0;
    size_t background_count_ = 0, shore_pairs_ = 0, inside_pairs_ = 0;
    double shore_ = 0, inside_ = 0;
};

}  // namespace wrinkle::maps
