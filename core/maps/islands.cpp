#include <algorithm>
#include <cmath>

#include "maps/measures.h"

namespace wrinkle::maps {

namespace {

constexpr float near = 2.5F / 255;  // tolerance for JPEG, which changes flat areas
constexpr size_t side = 8;

bool is_near(float value, float wanted) {
    return std::abs(value - wanted) <= near;
}

}  // namespace

bool IslandSums::is_background(const float* t) const {
    switch (background_) {
        case Background::normals:
            return (is_near(t[0], 0.5F) && is_near(t[1], 0.5F) && is_near(t[2], 1)) ||
                   (is_near(t[0], 0) && is_near(t[1], 0) && is_near(t[2], 0));
        case Background::zero:
            return is_near(t[0], 0);
        case Background::middle:
            return is_near(t[0], 0.5F);
    }
    return false;
}

void IslandSums::compare(const Row& a, size_t first_a, const Row& b, size_t first_b, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        const size_t m = first_a + i, n = first_b + i;
        const double step = std::abs(a.red[m] - b.red[n]) + std::abs(a.green[m] - b.green[n]);
        if (a.background[m] != b.background[n]) {
            shore_ += step;
            ++shore_pairs_;
        } else if (!a.background[m]) {
            inside_ += step;
            ++inside_pairs_;
        }
    }
}

void IslandSums::add(const float* row, uint32_t width, uint32_t channels) {
    std::swap(above_, here_);
    here_.red.resize(width);
    here_.green.resize(width);
    here_.background.resize(width);
    const uint32_t second = background_ == Background::normals ? 1 : 0;
    for (uint32_t x = 0; x < width; ++x, row += channels) {
        here_.red[x] = row[0];
        here_.green[x] = row[second];
        here_.background[x] = is_background(row);
        background_count_ += here_.background[x];
    }
    if (rows_++ % side == 0) plain_.assign(width / side, 1);
    for (size_t square = 0; square < plain_.size(); ++square)
        for (size_t x = square * side; x < (square + 1) * side; ++x)
            plain_[square] &= here_.background[x];
    if (rows_ % side == 0) plain_count_ += static_cast<size_t>(std::ranges::count(plain_, 1));
    compare(here_, 0, here_, 1, width - 1);
    if (!above_.red.empty()) compare(here_, 0, above_, 0, width);
}

IslandMeasures IslandSums::measures(double texels) const {
    return {static_cast<double>(background_count_) / texels,
            shore_ / std::max<double>(static_cast<double>(shore_pairs_), 1),
            inside_ / std::max<double>(static_cast<double>(inside_pairs_), 1),
            static_cast<double>(plain_count_ * side * side) / texels};
}

}  // namespace wrinkle::maps
