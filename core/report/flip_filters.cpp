// Kernels of FLIP, and filtering of rows and columns.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/flip_stages.h"

namespace wrinkle::report {
namespace {

constexpr double pi = std::numbers::pi;

// Widths of the contrast sensitivity in degrees (table 1): Y, Cx and the two parts of Cz.
constexpr double luma_width = 0.0047, cx_width = 0.0053;
constexpr std::array cz_amplitudes = {34.1, 13.5};
constexpr std::array cz_widths = {0.04, 0.025};
// Width of edges in degrees: 0.082, two standard deviations of the Gaussian.
constexpr double feature_deviation = 0.5 * 0.082;

// Returns w(0) to w(radius) of the Gaussian exp(-rate x^2).
std::vector<double> gaussian(double rate, uint32_t radius) {
    std::vector<double> weights;
    for (uint32_t x = 0; x <= radius; ++x)
        weights.push_back(std::exp(-rate * x * x));
    return weights;
}

double sum_of_both_sides(const std::vector<double>& weights) {
    double sum = -weights[0];
    for (const double weight : weights)
        sum += 2 * weight;
    return sum;
}

// Returns the even kernel of weights w(0) to w(radius), times a factor.
Kernel even_kernel(const std::vector<double>& weights, double factor) {
    Kernel kernel;
    kernel.sum = static_cast<float>(sum_of_both_sides(weights) * factor);
    for (size_t i = 1; i < weights.size(); ++i)
        kernel.weights.push_back(static_cast<float>(weights[i] * factor));
    return kernel;
}

Kernel normalized(const std::vector<double>& weights) {
    return even_kernel(weights, 1 / sum_of_both_sides(weights));
}

// The two-dimensional weights of both parts have the sum 1 together.
void make_cz(Filters& filters, double pixels_per_degree, uint32_t radius) {
    std::array<std::vector<double>, 2> parts;
    double total = 0;
    for (size_t i = 0; i < 2; ++i) {
        parts[i] = gaussian(pi * pi / cz_widths[i] / pixels_per_degree / pixels_per_degree, radius);
        for (double& weight : parts[i])
            weight *= std::sqrt(cz_amplitudes[i] * std::sqrt(pi / cz_widths[i]));
        total += std::pow(sum_of_both_sides(parts[i]), 2);
    }
    for (size_t i = 0; i < 2; ++i)
        filters.cz[i] = even_kernel(parts[i], 1 / std::sqrt(total));
}

// Divides the positive weights by their sum and the negative ones by the magnitude of theirs.
void make_features(Filters& filters, double pixels_per_degree) {
    const double deviation = feature_deviation * pixels_per_degree;
    const auto radius = static_cast<uint32_t>(std::ceil(3 * deviation));
    const auto smooth = gaussian(0.5 / (deviation * deviation), radius);
    filters.smooth = normalized(smooth);
    std::vector<double> edge, point;
    double edge_sum = 0, positive = 0, negative = 0;
    for (uint32_t x = 0; x <= radius; ++x) {
        edge.push_back(-1.0 * x * smooth[x]);
        edge_sum += x * smooth[x];
        point.push_back((x * x / (deviation * deviation) - 1) * smooth[x]);
        (point[x] > 0 ? positive : negative) += point[x] * (x == 0 ? 1 : 2);
    }
    for (double& weight : point)
        weight /= weight > 0 ? positive : -negative;
    filters.edge = even_kernel(edge, 1 / edge_sum);
    filters.edge.sum = 0;
    filters.edge.odd = true;
    filters.point = even_kernel(point, 1);
    filters.point.sum = 0;
}

// Adds w(i) of one distance i to a row: sum f(x) + w(i) (f(x + i) + f(x - i) - 2 f(x)) in total,
// which is exact for constant rows.
void add_even(float* out, const float* before, const float* centre, const float* after,
              float weight, uint32_t count) {
    for (uint32_t x = 0; x < count; ++x)
        out[x] += weight * ((before[x] - centre[x]) + (after[x] - centre[x]));
}

void add_odd(float* out, const float* before, const float* after, float weight, uint32_t count) {
    for (uint32_t x = 0; x < count; ++x)
        out[x] += weight * (after[x] - before[x]);
}

// Filters one row; row_at(i) returns the row shifted by i pixels or the row i further up.
template <class RowAt>
void filter_row(float* out, uint32_t count, const Kernel& kernel, const RowAt& row_at) {
    const float* centre = row_at(0);
    for (uint32_t x = 0; x < count; ++x)
        out[x] = kernel.sum * centre[x];
    for (int i = 1; i <= static_cast<int>(kernel.radius()); ++i) {
        const float weight = kernel.weights[static_cast<size_t>(i) - 1];
        if (kernel.odd)
            add_odd(out, row_at(-i), row_at(i), weight, count);
        else
            add_even(out, row_at(-i), centre, row_at(i), weight, count);
    }
}

}  // namespace

uint32_t Filters::margin() const {
    return std::max(luma.radius(), smooth.radius());
}

Filters make_filters(double pixels_per_degree) {
    Filters filters;
    const double widest = 3 * std::sqrt(cz_widths[0] / (2 * pi * pi));
    const auto radius = static_cast<uint32_t>(std::ceil(widest * pixels_per_degree));
    const double rate = pi * pi / pixels_per_degree / pixels_per_degree;
    filters.luma = normalized(gaussian(rate / luma_width, radius));
    filters.cx = normalized(gaussian(rate / cx_width, radius));
    make_cz(filters, pixels_per_degree, radius);
    make_features(filters, pixels_per_degree);
    return filters;
}

Plane filter_x(const Plane& plane, const Kernel& kernel) {
    Plane result = make_image(plane.width, plane.height, 1);
    const uint32_t margin = kernel.radius();
    std::vector<float> padded(plane.width + 2 * size_t{margin});
    float* inside = padded.data() + margin;
    for (uint32_t y = 0; y < plane.height; ++y) {
        const float* row = plane.texel(0, y);
        std::fill_n(padded.data(), margin, row[0]);
        std::copy_n(row, plane.width, inside);
        std::fill_n(inside + plane.width, margin, row[plane.width - 1]);
        filter_row(result.texel(0, y), plane.width, kernel, [&](int i) { return inside + i; });
    }
    return result;
}

Plane filter_y(const Plane& plane, const Kernel& kernel, uint32_t margin) {
    Plane result = make_image(plane.width, plane.height - 2 * margin, 1);
    for (uint32_t y = 0; y < result.height; ++y) {
        const int middle = static_cast<int>(y + margin);
        filter_row(result.texel(0, y), plane.width, kernel,
                   [&](int i) { return plane.texel(0, static_cast<uint32_t>(middle + i)); });
    }
    return result;
}

}  // namespace wrinkle::report
