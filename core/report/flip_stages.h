// Stages of LDR-FLIP (flip.h): color space, filters, errors of color and of features. Sections are
// those of Andersson et al. 2020.
//
// A plane is an image of one channel. Colors are three numbers: YCxCz is a linear opponent space,
// Lab is CIELAB with the Hunt effect (a and b times 0.01 L), both for the white of D65.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace wrinkle::report {

using Plane = Image;
using Color = std::array<double, 3>;

Color ycxcz_from_linear(const Color& rgb);  // rgb in [0, 1]
// Clamps the color to [0, 1] as linear RGB.
Color lab_from_ycxcz(const Color& ycxcz);

// One-dimensional filter with the weights w(-i) = w(i), or -w(i) if it is odd; w(0) follows from
// the sum.
struct Kernel {
    std::vector<float> weights;  // [i - 1] is w(i)
    float sum = 0;               // sum of all weights, with w(0)
    bool odd = false;

    uint32_t radius() const { return static_cast<uint32_t>(weights.size()); }
};

// Filters of an observer at a distance; all have weights up to their own radius.
struct Filters {
    Kernel luma, cx, cz[2];      // contrast sensitivity (4.1.1); Cz is the sum of two
    Kernel smooth, edge, point;  // Gaussian, its first and second derivative (4.2)

    uint32_t margin() const;  // the largest radius
};
// Precondition: min_pixels_per_degree <= pixels_per_degree <= max_pixels_per_degree.
Filters make_filters(double pixels_per_degree);

// Filters rows; coordinates are clamped at the border.
Plane filter_x(const Plane& plane, const Kernel& kernel);
// Filters columns and drops `margin` rows at both ends. Precondition: margin >= kernel.radius().
Plane filter_y(const Plane& plane, const Kernel& kernel, uint32_t margin);

// Filtered values of some rows of an image.
struct Stages {
    std::array<Plane, 3> ycxcz;  // filtered
    Plane edge, point;           // lengths of the features
};
// `image` is linear RGB.
Stages make_stages(const Image& image, const Filters& filters, uint32_t first_row, uint32_t rows);

// Error in [0, 1] of two colors: HyAB^0.7, remapped (4.1.2, 4.1.3).
float color_error(const Color& lab_a, const Color& lab_b);
// Error in [0, 1] from the differences of the lengths of features (4.2).
float feature_error(float edge_difference, float point_difference);
float flip_error(float color, float feature);  // 4.3

// FLIP of a pixel of two stages.
float flip_error(const Stages& a, const Stages& b, uint32_t x, uint32_t y);

}  // namespace wrinkle::report
