// Tests of highlights of a bump finer than a pixel, against the same bump in full resolution: the
// reflection of a pixel is the mean over its area, with an independent implementation of the lobe.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nodes/plane.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

constexpr uint32_t picture_size = 256;
// Pixel size in uv units, from the number of texels per pixel.
constexpr uint32_t texels_a_pixel = 16;
constexpr double pixel_uv = double(texels_a_pixel) / picture_size;

// Waves of several directions and lengths, all of them shorter than a pixel, on two long ones.
std::array<double, 2> slopes_at(double u, double v) {
    const double a = std::cos(full_circle * (16 * u + 3 * v)),
                 b = std::sin(full_circle * (19 * v - 5 * u)),
                 c = std::cos(full_circle * (23 * u + 11 * v) + 1),
                 d = std::sin(full_circle * (17 * u - 26 * v));
    return {0.22 * a - 0.06 * b + 0.2 * c + 0.16 * d + 0.1 * std::sin(full_circle * v),
            0.04 * a + 0.2 * b + 0.1 * c - 0.2 * d - 0.1 * std::cos(full_circle * u)};
}

const std::string normal_file = "textures/weave_normal.png",
                  slope_file = "textures/pebbles_slopes.png",
                  moment_file = "textures/weave_height.png";

std::map<std::string, Image> pictures() {
    return {{normal_file, painted(picture_size,
                                  [](double u, double v) {
                                      const auto [x, y] = slopes_at(u, v);
                                      const double k = 0.5 / std::sqrt(1 + x * x + y * y);
                                      return std::array{0.5 - x * k, 0.5 - y * k, 0.5 + k};
                                  })},
            {slope_file, painted(picture_size,
                                 [](double u, double v) {
                                     const auto [x, y] = slopes_at(u, v);
                                     return std::array{x, y, 0.0};
                                 })},
            {moment_file, painted(picture_size, [](double u, double v) {
                 const auto [x, y] = slopes_at(u, v);
                 return std::array{x * x, y * y, x * y};
             })}};
}

// The plane's points with pixels of this many uv units.
PointSet points_of(const Scene& scene, const std::vector<std::array<double, 2>>& at,
                   double footprint) {
    PointSet set = plane_points(scene, at);
    for (auto& variants : set.values)
        for (const Variant change : {Variant::dx, Variant::dy})
            for (double& number : variants[static_cast<size_t>(change)])
                number *= footprint / pixel;
    return set;
}

// Trowbridge-Reitz distribution: area of microfacets of this roughness that face h.
double lobe(double cosine, double roughness) {
    const double a2 = std::pow(roughness, 4);
    const double d = cosine * cosine * (a2 - 1) + 1;
    return a2 / (std::numbers::pi * d * d);
}

constexpr int directions = 12;
using Highlight = std::array<double, directions>;

// Reflection for half vectors at increasing angles from the surface's normal, averaged over
// azimuths.
Highlight highlight(const std::vector<double>& normal, double roughness) {
    Highlight sum{};
    constexpr int azimuths = 32;
    for (int i = 0; i < directions; ++i)
        for (int k = 0; k < azimuths; ++k) {
            const double tilt = 0.05 * i, around = full_circle * k / azimuths;
            const double cosine = normal[0] * std::sin(tilt) * std::cos(around) +
                                  normal[1] * std::sin(tilt) * std::sin(around) +
                                  normal[2] * std::cos(tilt);
            sum[size_t(i)] += lobe(std::fmax(cosine, 0), roughness) / azimuths;
        }
    return sum;
}

struct Comparison {
    double with, without;  // mean absolute errors, relative to the mean of the reference
};

constexpr double base_roughness = 0.3;

// `nodes` defines a node named `bump` with the output `gradient`.
Comparison errors_of(const std::string& nodes) {
    const auto output = [&](const std::string& port) {
        return Scene{nodes + R"(, "rough": {"type": "bump_roughness", "in": {"gradient": {"from":
                     "bump.gradient"}, "roughness": 0.3}}, "end": {"type": "resolve", "in":
                     {"gradient": {"from": "bump.gradient"}}})",
                     port,
                     {},
                     {0, 0, 1},
                     {0, 0, 1},
                     pictures()};
    };
    const Scene rough = output("rough.roughness"), normal = output("end.normal");
    Comparison result{};
    double truth = 0;
    for (int p = 0; p < 6; ++p) {
        const std::array<double, 2> at{0.11 + 0.13 * p, 0.57 - 0.09 * p};
        const auto far_normal = values(normal, points_of(normal, {at}, pixel_uv));
        const auto far_rough = values(rough, points_of(rough, {at}, pixel_uv));
        // The footprint of the mip level in use: a box of texels, wider between four texels.
        std::vector<std::array<double, 2>> inside;
        constexpr int steps = 48;
        for (int i = 0; i < steps * steps; ++i)
            inside.push_back({at[0] + pixel_uv * ((i % steps + 0.5) / steps - 0.5),
                              at[1] + pixel_uv * ((i / steps + 0.5) / steps - 0.5)});
        Highlight right{};
        for (const auto& near : values(normal, points_of(normal, inside, 1e-6))) {
            const Highlight one = highlight(near, base_roughness);
            for (size_t i = 0; i < directions; ++i)
                right[i] += one[i] / (steps * steps);
        }
        const Highlight with = highlight(far_normal[0], far_rough[0][0]);
        const Highlight without = highlight(far_normal[0], base_roughness);
        for (size_t i = 0; i < directions; ++i) {
            truth += right[i];
            result.with += std::fabs(with[i] - right[i]);
            result.without += std::fabs(without[i] - right[i]);
        }
    }
    return {result.with / truth, result.without / truth};
}

void expect_kept(const std::string& nodes) {
    const Comparison errors = errors_of(nodes);
    EXPECT_LT(errors.with, 0.25);
    EXPECT_GT(errors.without, 1);
}

const std::string one_map =
    R"("bump": {"type": "tangent_normal_map", "in": {"image": ")" + normal_file + R"("}})";

TEST(BumpRoughness, KeepsTheHighlightOfANormalMap) {
    expect_kept(one_map);
}

TEST(BumpRoughness, KeepsTheHighlightOfLayers) {
    expect_kept(
        R"("a": {"type": "tangent_normal_map", "in": {"image": ")" + normal_file +
        R"(", "strength": 0.7}}, "tile": {"type": "uv_transform", "in": {"scale": [1.6, 1.6],
                "rotation": 30}}, "b": {"type": "tangent_normal_map", "in": {"image": ")" +
        normal_file + R"(", "uv": {"from": "tile.uv"}}}, "bump": {"type": "gradient_mix",
                "in": {"a": {"from": "a.gradient"}, "b": {"from": "b.gradient"}, "mask": 0.4}})");
}

TEST(BumpRoughness, KeepsTheHighlightOfSlopesWithMoments) {
    expect_kept(R"("bump": {"type": "slope_moments_map", "in": {"slopes": ")" + slope_file +
                R"(", "moments": ")" + moment_file + R"("}})");
}

}  // namespace
}  // namespace wrinkle::test
