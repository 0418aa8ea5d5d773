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
        const double red = t[0] * 255.0 - 127.5, green = t[1] * 255.0 - 127.5;
        if (std::abs(red) < 1 && std::abs(green) < 1) continue;
        red_ += red;
        green_ += green;
        ++tilted_;
    }
}

OffsetMeasures OffsetSums::measures(double texels) const {
    const double count = std::max<double>(static_cast<double>(tilted_), 1);
    return {red_ / count, green_ / count, static_cast<double>(tilted_) / texels};
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

Measuring::Measuring(const ImageInfo& info, Wrap wrap)
    : info_(info),
      colors_(info.channels - (info.has_alpha ? 1 : 0)),
      curl_(info.width, info.height, wrap),
      made_curl_(info.width, info.height, wrap) {
    const uint32_t count = std::min(colors_, 2u);
    if (is_integer(info.source)) steps_.assign(count, StepSums(info.source));
    seams_.assign(count, SeamSums(info.width));
    islands_ = {IslandSums(IslandSums::Background::zero),
                IslandSums(IslandSums::Background::middle)};
    if (colors_ >= 3) islands_.emplace_back(IslandSums::Background::normals);
}

void Measuring::add(const float* row) {
    const uint32_t width = info_.width, channels = info_.channels;
    not_finite_ += static_cast<size_t>(std::count_if(row, row + size_t{width} * channels,
                                                     [](float t) { return !std::isfinite(t); }));
    if (not_finite_ > 0) return;  // statistics of NaN are undefined
    if (colors_ >= 3) {
        vectors_.add(row, width, channels);
        curl_.add(row, channels, colors_);
    }
    if (colors_ >= 2) {
        made_curl_.add(row, channels, 2);
        if (info_.source == PixelType::u8) offset_.add(row, width, channels);
    }
    for (uint32_t channel = 0; channel < seams_.size(); ++channel)
        seams_[channel].add(row, channels, channel);
    for (IslandSums& islands : islands_)
        islands.add(row, width, channels);
    for (size_t i = 0; i < size_t{width} * channels; i += channels) {
        lowest_ = std::min(lowest_, row[i]);
        highest_ = std::max(highest_, row[i]);
    }
    for (uint32_t channel = 0; channel < steps_.size(); ++channel)
        steps_[channel].add(row, width, channels, channel);
}

IslandMeasures Measuring::islands(bool of_normals) const {
    if (of_normals) return islands_.back().measures(texels());
    const IslandMeasures zero = islands_[0].measures(texels());
    const IslandMeasures middle = islands_[1].measures(texels());
    return zero.background > middle.background ? zero : middle;
}

SeamMeasures Measuring::seam(uint32_t channels, bool across_u) const {
    const uint32_t length = across_u ? info_.height : info_.width;
    std::vector<double> sums(across_u ? info_.width : info_.height);
    for (uint32_t channel = 0; channel < channels; ++channel) {
        const std::vector<double> one =
            across_u ? seams_[channel].across_u() : seams_[channel].across_v();
        for (size_t line = 0; line < sums.size(); ++line)
            sums[line] += one[line] / (static_cast<double>(length) * channels);
    }
    const double border = sums.back();
    sums.pop_back();
    std::vector<double>& inside = sums;
    if (inside.empty()) return {};
    const auto percentile = inside.begin() + static_cast<ptrdiff_t>((inside.size() - 1) * 99 / 100);
    std::nth_element(inside.begin(), percentile, inside.end());
    return {border, *percentile};
}

}  // namespace wrinkle::maps
