// Directional albedo of OpenPBR's fuzz: the fraction of light that white fuzz reflects in total, by
// the cosine of the view direction and fuzz_roughness (Zeltner, Burley and Chiang, "Practical
// Multiple-Scattering Sheen Using Linearly Transformed Cosines", 2022, with the fit of MaterialX
// 1.39).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace wrinkle {

constexpr double min_fuzz_roughness = 0.01;  // the least the fit covers

inline double fuzz_albedo(double cosine, double roughness) {
    const double x = std::clamp(cosine, 0.0, 1.0);
    const double y = std::clamp(roughness, min_fuzz_roughness, 1.0);
    const double s = y * (0.0206607 + 1.58491 * y) / (0.0379424 + y * (1.32227 + y));
    const double m =
        y * (-0.193854 + y * (-1.14885 + y * (1.7932 - 0.95943 * y * y))) / (0.046391 + y);
    const double o =
        y * (0.000654023 + (-0.0207818 + 0.119681 * y) * y) / (1.26264 + y * (-1.92021 + y));
    const double away = (x - m) / s;
    const double bell = std::exp(-0.5 * away * away) / (s * std::sqrt(2 * std::numbers::pi));
    return std::clamp(bell + o, 0.0, 1.0);
}

// The same in GLSL: statements that set `albedo` from the floats x and y, both clamped.
constexpr std::string_view fuzz_albedo_text = R"(
float s = y * (0.0206607 + 1.58491 * y) / (0.0379424 + y * (1.32227 + y));
float m = y * (-0.193854 + y * (-1.14885 + y * (1.7932 - 0.95943 * y * y))) / (0.046391 + y);
float o = y * (0.000654023 + (-0.0207818 + 0.119681 * y) * y) / (1.26264 + y * (-1.92021 + y));
float away = (x - m) / s;
float albedo = clamp(exp(-0.5 * away * away) / (s * 2.5066283) + o, 0.0, 1.0);
)";

}  // namespace wrinkle
