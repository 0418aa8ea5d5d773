#include "maps/measures.h"

#include <algorithm>
#include <cmath>

namespace wrinkle::maps {

namespace {

constexpr double unit_tolerance = 0.1;
constexpr float spike = 4;
constexpr double certain_region = 0.5;   // correlation
constexpr double min_of_regions = 4096;  // texels

}  // namespace

void VectorSums::add(const float* t, uint32_t width, uint32_t channels) {
    constexpr double shortest = (1 - unit_tolerance) * (1 - unit_tolerance),
                     longest = (1 + unit_tolerance) * (1 + unit_tolerance);
    for (uint32_t i = 0; i < width; ++i, t += channels) {
        if (t[0] == 0 && t[1] == 0 && t[2] == 0) {
            ++empty_;
            continue;
        }
        const double x = 2.0 * t[0] - 1, y = 2.0 * t[1] - 1, z = 2.0 * t[2] - 1;
        const double flat = x * x + y * y, square = flat + z * z;
        const double made = std::sqrt(std::max(0.0, 1 - flat));
        unit_ += square > shortest && square < longest;
        downward_ += z < -unit_tolerance;
        const float low = std::min(std::min(t[0], t[1]), t[2]);
        const float high = std::max(std::max(t[0], t[1]), t[2]);
        gray_ += high - low < 2.5 * u8_step;
        sums_.mean[0] += x;
        sums_.mean[1] += y;
        sums_.mean[2] += z;
        const double with_sign = t[2] - (1 + made) / 2, without = t[2] - made;
        sums_.signed_z += with_sign * with_sign;
        sums_.unsigned_z += without * without;
        sums_.between_z += (1 - made) * (1 - made) / 4;
        lowest_blue_ = std::min<double>(lowest_blue_, t[2]);
        highest_blue_ = std::max<double>(highest_blue_, t[2]);
    }
}

VectorMeasures VectorSums::measures(double texels) const {
    VectorMeasures result = sums_;
    result.empty = static_cast<double>(empty_) / texels;
    const double count = std::max(texels - static_cast<double>(empty_), 1.0);
    result.unit = static_cast<double>(unit_) / count;
    result.downward = static_cast<double>(downward_) / count;
    result.gray = static_cast<double>(gray_) / count;
    for (double& mean : result.mean)
        mean /= count;
    for (double* square : {&result.signed_z, &result.unsigned_z, &result.between_z})
        *square = std::sqrt(*square / count);
    result.blue_spread = highest_blue_ - lowest_blue_;
    return result;
}

CurlSums::CurlSums(uint32_t width, uint32_t height, Wrap wrap)
    : width_(width), height_(height), wrap_(wrap) {
    for (SlopeRow* row : {&last_[0], &last_[1], &last_[2]}) {
        row->du.resize(width);
        row->dv.resize(width);
    }
}

void CurlSums::add(const SlopeRow& above, const SlopeRow& here, const SlopeRow& below, uint32_t y,
                   RegionSums& sums) const {
    const uint32_t count = width_;
    thread_local std::vector<float> unused, u_along_v, v_along_u;
    for (std::vector<float>* row : {&unused, &u_along_v, &v_along_u})
        row->resize(count);
    sobel_row({above.du.data(), here.du.data(), below.du.data()}, count, wrap_, unused.data(),
              u_along_v.data());
    sobel_row({above.dv.data(), here.dv.data(), below.dv.data()}, count, wrap_, v_along_u.data(),
              unused.data());
    uint32_t x = 0;
    for (uint32_t column = 0; column < regions; ++column) {
        Sums& region = sums[size_t{y} * regions / height_][column];
        for (const size_t end = (column + 1) * size_t{count} / regions; x < end; ++x) {
            const double a = u_along_v[x] / 8, b = v_along_u[x] / 8;
            region.uu += a * a;
            region.vv += b * b;
            region.uv += a * b;
        }
    }
}

void CurlSums::add(const float* row, uint32_t stride, uint32_t channels) {
    SlopeRow& here = last_[rows_ % 3];
    slopes_of_normals(row, stride, channels, 1, width_, here.du.data(), here.dv.data());
    for (std::vector<float>* slopes : {&here.du, &here.dv})
        for (float& value : *slopes)
            value = std::isfinite(value) ? std::clamp(value, -spike, spike) : 0;
    if (rows_ == 0) first_ = here;
    if (rows_ == 1) second_ = here;
    if (rows_ >= 2) add(last_[(rows_ - 2) % 3], last_[(rows_ - 1) % 3], here, rows_ - 1, sums_);
    ++rows_;
}

CurlMeasures CurlSums::measures() const {
    // The first and the last row are neighbours (repeat) or their own neighbours (clamp).
    RegionSums sums = sums_;
    const SlopeRow& end = last_[(height_ - 1) % 3];
    const bool repeats = wrap_ == Wrap::repeat;
    add(repeats ? end : first_, first_, height_ > 1 ? second_ : first_, 0, sums);
    if (height_ > 1) add(last_[(height_ - 2) % 3], end, repeats ? first_ : end, height_ - 1, sums);
    Sums all;
    for (const auto& row : sums)
        for (const Sums& region : row) {
            all.uu += region.uu;
            all.vv += region.vv;
            all.uv += region.uv;
        }
    const double count = static_cast<double>(width_) * height_;
    CurlMeasures curl;
    curl.gl = std::sqrt(std::max(0.0, all.uu - 2 * all.uv + all.vv) / count);
    curl.dx = std::sqrt(std::max(0.0, all.uu + 2 * all.uv + all.vv) / count);
    curl.correlation = all.uu > 0 && all.vv > 0 ? all.uv / std::sqrt(all.uu * all.vv) : 0;
    double weights = 0;
    for (const auto& row : sums)
        for (const Sums& region : row) {
            const double weight = std::sqrt(region.uu * region.vv);
            weights += weight;
            if (region.uv > certain_region * weight) curl.regions_gl += weight;
            if (region.uv < -certain_region * weight) curl.regions_dx += weight;
        }
    if (weights == 0 || count < min_of_regions) {
        curl.regions_gl = curl.regions_dx = 0;
        return curl;
    }
    curl.regions_gl /= weights;
    curl.regions_dx /= weights;
    return curl;
}

void OffsetSums::add(const float* t, uint32_t width, uint32_t channels) {
    for (uint32_t x = 0; x < width; ++x, t += channels) {
        const double steps_red = t[0] * 255.0 - 127.5, steps_green = t[1] * 255.0 - 127.5;
        if (std::abs(steps_red) < 1 && std::abs(steps_green) < 1) continue;
        red += steps_red;
        green += steps_green;
        ++tilted;
    }
}

void StepSums::add(const float* row, uint32_t width, uint32_t channels, uint32_t channel) {
    const float highest = type_ == PixelType::u8 ? 255.0f : 65535.0f;
    const bool has_above = !here_.empty();
    std::swap(here_, above_);
    here_.resize(width);
    for (uint32_t x = 0; x < width; ++x) {
        const float t = std::clamp(row[size_t{x} * channels + channel], 0.0f, 1.0f);
        here_[x] = static_cast<int>(t * highest + 0.5f);
    }
    for (const int value : here_)
        seen_[static_cast<size_t>(value)] = 1;
    const auto compare = [&](const int* a, const int* b, uint32_t count) {
        uint32_t still = 0, one = 0;
        for (uint32_t x = 0; x < count; ++x) {
            const int step = std::abs(a[x] - b[x]);
            still += step == 0;
            one += step == 1;
        }
        still_ += still;
        one_ += one;
        pairs_ += count;
    };
    compare(here_.data(), here_.data() + 1, width - 1);
    if (has_above) compare(here_.data(), above_.data(), width);
}

StepMeasures StepSums::measures() const {
    StepMeasures steps;
    steps.eight_bits = type_ == PixelType::u16;
    for (size_t i = 0; i < seen_.size(); ++i) {
        steps.levels += seen_[i];
        if (seen_[i] && i % 257 != 0) steps.eight_bits = false;
    }
    const double pairs = std::max<double>(static_cast<double>(pairs_), 1);
    steps.still = static_cast<double>(still_) / pairs;
    steps.one = static_cast<double>(one_) / pairs;
    return steps;
}

namespace {

double step_of(float a, float b) {
    return std::isfinite(a - b) ? std::abs(static_cast<double>(a) - b) : 0;
}

double steps_between(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (size_t x = 0; x < a.size(); ++x)
        sum += step_of(a[x], b[x]);
    return sum;
}

}  // namespace

void SeamSums::add(const float* row, uint32_t channels, uint32_t channel) {
    const size_t width = across_u_.size();
    std::swap(here_, above_);
    here_.resize(width);
    for (size_t x = 0; x < width; ++x)
        here_[x] = row[x * channels + channel];
    for (size_t x = 0; x + 1 < width; ++x)
        across_u_[x] += step_of(here_[x], here_[x + 1]);
    across_u_.back() += step_of(here_.back(), here_.front());
    if (first_.empty())
        first_ = here_;
    else
        across_v_.push_back(steps_between(above_, here_));
}

std::vector<double> SeamSums::across_v() const {
    std::vector<double> sums = across_v_;
    sums.push_back(steps_between(here_, first_));
    return sums;
}

}  // namespace wrinkle::maps
