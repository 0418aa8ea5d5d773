// The separable filters of FLIP against sums over the square of weights, in double and with the
// weights of the paper's formulas in two dimensions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "report/flip_stages.h"
#include "report/support.h"

namespace wrinkle::test {
namespace {

using namespace report;

using Weight = std::function<double(int x, int y)>;

// Divides by the sum; of weights with two signs, positive and negative ones by their own sums.
struct Square {
    int radius = 0;
    std::vector<double> weights;

    Square(int radius, const Weight& weight, bool signs) : radius(radius) {
        double positive = 0, negative = 0;
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x) {
                weights.push_back(weight(x, y));
                (weights.back() > 0 ? positive : negative) += weights.back();
            }
        for (double& value : weights)
            value /= !signs ? positive + negative : value > 0 ? positive : -negative;
    }

    double at(const Plane& plane, int px, int py) const {
        double sum = 0;
        size_t i = 0;
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x) {
                const int cx = std::clamp(px + x, 0, int(plane.width) - 1);
                const int cy = std::clamp(py + y, 0, int(plane.height) - 1);
                sum += weights[i++] * *plane.texel(uint32_t(cx), uint32_t(cy));
            }
        return sum;
    }
};

Image noise(uint32_t width, uint32_t height) {
    Image image = make_image(width, height, 3);
    uint32_t state = 1;
    for (float& value : image.data) {
        state = state * 1664525 + 1013904223;
        value = static_cast<float>(state >> 8) / 16777216.0F;
    }
    return image;
}

// The planes before filters.
std::array<Plane, 3> planes_of(const Image& image) {
    std::array<Plane, 3> planes;
    for (Plane& plane : planes)
        plane = make_image(image.width, image.height, 1);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const float* t = image.texel(x, y);
            const Color color = ycxcz_from_linear({t[0], t[1], t[2]});
            for (size_t c = 0; c < 3; ++c)
                *planes[c].texel(x, y) = static_cast<float>(color[c]);
        }
    return planes;
}

double contrast(double a, double b, double degrees2) {
    constexpr double pi = std::numbers::pi;
    return a * std::sqrt(pi / b) * std::exp(-pi * pi * degrees2 / b);
}

class Filtering : public testing::TestWithParam<double> {
protected:
    double ppd = GetParam();
    Image image = noise(23, 17);
    Stages stages = make_stages(image, make_filters(ppd), 0, image.height);

    void expect_plane(const Plane& plane, const std::function<double(int, int)>& expected,
                      double tolerance) const {
        for (int y = 0; y < int(plane.height); ++y)
            for (int x = 0; x < int(plane.width); ++x)
                ASSERT_NEAR(*plane.texel(uint32_t(x), uint32_t(y)), expected(x, y), tolerance)
                    << x << ", " << y;
    }
};

TEST_P(Filtering, OfContrastIsTheSumOverASquare) {
    const auto planes = planes_of(image);
    const int radius = int(std::ceil(0.135047 * ppd));
    const auto degrees2 = [&](int x, int y) { return (x * x + y * y) / (ppd * ppd); };
    const Weight weights[] = {
        [&](int x, int y) { return contrast(1, 0.0047, degrees2(x, y)); },
        [&](int x, int y) { return contrast(1, 0.0053, degrees2(x, y)); },
        [&](int x, int y) {
            return contrast(34.1, 0.04, degrees2(x, y)) + contrast(13.5, 0.025, degrees2(x, y));
        },
    };
    for (size_t c = 0; c < 3; ++c) {
        const Square square(radius, weights[c], false);
        expect_plane(
            stages.ycxcz[c], [&](int x, int y) { return square.at(planes[c], x, y); }, 1e-4);
    }
}

TEST_P(Filtering, OfFeaturesIsTheSumOverASquare) {
    Plane gray = planes_of(image)[0];
    for (float& value : gray.data)
        value = (value + 16) / 116;
    const int radius = int(std::ceil(0.123 * ppd));
    const double s2 = std::pow(0.041 * ppd, 2);
    const auto bell = [&](int x, int y) { return std::exp(-(x * x + y * y) / (2 * s2)); };
    const Square edge_x(
        radius, [&](int x, int y) { return -x * bell(x, y); }, true);
    const Square edge_y(
        radius, [&](int x, int y) { return -y * bell(x, y); }, true);
    const Square point_x(
        radius, [&](int x, int y) { return (x * x / s2 - 1) * bell(x, y); }, true);
    const Square point_y(
        radius, [&](int x, int y) { return (y * y / s2 - 1) * bell(x, y); }, true);
    expect_plane(
        stages.edge,
        [&](int x, int y) { return std::hypot(edge_x.at(gray, x, y), edge_y.at(gray, x, y)); },
        1e-6);
    expect_plane(
        stages.point,
        [&](int x, int y) { return std::hypot(point_x.at(gray, x, y), point_y.at(gray, x, y)); },
        1e-6);
}

// The distances at which radii of both kinds differ, and the default.
INSTANTIATE_TEST_SUITE_P(Distances, Filtering, testing::Values(10.0, 40.0, 67.0206433));

TEST(FilterRadii, AreThoseOfTheOriginal) {
    const std::array<std::array<double, 3>, 5> radii = {
        {{10, 2, 2}, {20, 3, 3}, {40, 6, 5}, {67.02, 10, 9}, {90.5, 13, 12}}};
    for (const auto& [ppd, spatial, feature] : radii) {
        const Filters filters = make_filters(ppd);
        EXPECT_EQ(filters.luma.radius(), spatial) << ppd;
        EXPECT_EQ(filters.cz[0].radius(), spatial) << ppd;
        EXPECT_EQ(filters.edge.radius(), feature) << ppd;
        EXPECT_EQ(filters.point.radius(), feature) << ppd;
    }
}

TEST(FilterSums, AreExactForConstantRows) {
    const Filters filters = make_filters(67);
    const Plane constant = filled(5, 1, {0.1F});
    EXPECT_EQ(filter_x(constant, filters.luma).data, constant.data);
    EXPECT_EQ(filter_x(constant, filters.edge).data, std::vector<float>(5, 0));
    EXPECT_EQ(filter_x(constant, filters.point).data, std::vector<float>(5, 0));
}

}  // namespace
}  // namespace wrinkle::test
