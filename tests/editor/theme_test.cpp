// Tests of the colors of both themes: contrast by WCAG 2.1; differences of the type colors by
// CIEDE2000 (Sharma, Wu, Dalal 2005) under simulated color vision deficiencies (Machado, Oliveira,
// Fernandes 2009).
#include "editor/view/look/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace wrinkle::editor {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple linear(ImU32 color) {
    Triple rgb;
    for (unsigned i = 0; i < 3; ++i) {
        const double value = (color >> (8 * i) & 255) / 255.0;
        rgb[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    return rgb;
}

double contrast(ImU32 a, ImU32 b) {
    const auto luminance = [](ImU32 color) {
        const Triple c = linear(color);
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
}

Triple times(const Matrix& m, const Triple& v) {
    Triple result{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k)
            result[i] += m[i][k] * v[k];
    return result;
}

Triple lab(const Triple& rgb) {
    constexpr Matrix to_xyz = {{{0.4124564, 0.3575761, 0.1804375},
                                {0.2126729, 0.7151522, 0.0721750},
                                {0.0193339, 0.1191920, 0.9503041}}};
    constexpr Triple white = {0.95047, 1, 1.08883};
    Triple f = times(to_xyz, rgb);
    for (size_t i = 0; i < 3; ++i) {
        f[i] /= white[i];
        f[i] = f[i] > 216.0 / 24389 ? std::cbrt(f[i]) : (24389.0 / 27 * f[i] + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

double hue(double b, double a) {
    if (a == 0 && b == 0) return 0;
    const double degrees = std::atan2(b, a) * 180 / std::numbers::pi;
    return degrees < 0 ? degrees + 360 : degrees;
}

double ciede2000(const Triple& p, const Triple& q) {
    const double mean_c = (std::hypot(p[1], p[2]) + std::hypot(q[1], q[2])) / 2;
    const double g =
        0.5 * (1 - std::sqrt(std::pow(mean_c, 7) / (std::pow(mean_c, 7) + std::pow(25.0, 7))));
    const double a1 = (1 + g) * p[1], a2 = (1 + g) * q[1];
    const double c1 = std::hypot(a1, p[2]), c2 = std::hypot(a2, q[2]);
    const double h1 = hue(p[2], a1), h2 = hue(q[2], a2);
    double dh = h2 - h1;
    if (c1 * c2 == 0) dh = 0;
    if (dh > 180) dh -= 360;
    if (dh < -180) dh += 360;
    const double big_dh = 2 * std::sqrt(c1 * c2) * std::sin(radians(dh / 2));
    const double l = (p[0] + q[0]) / 2, c = (c1 + c2) / 2;
    double h = h1 + h2;
    if (c1 * c2 != 0)
        h = std::fabs(h1 - h2) <= 180 ? h / 2 : h < 360 ? (h + 360) / 2 : (h - 360) / 2;
    const double t = 1 - 0.17 * std::cos(radians(h - 30)) + 0.24 * std::cos(radians(2 * h)) +
                     0.32 * std::cos(radians(3 * h + 6)) - 0.20 * std::cos(radians(4 * h - 63));
    const double turn = 30 * std::exp(-std::pow((h - 275) / 25, 2));
    const double rc = 2 * std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25.0, 7)));
    const double sl = 1 + 0.015 * std::pow(l - 50, 2) / std::sqrt(20 + std::pow(l - 50, 2));
    const double x = (q[0] - p[0]) / sl, y = (c2 - c1) / (1 + 0.045 * c);
    const double z = big_dh / (1 + 0.015 * c * t);
    return std::sqrt(x * x + y * y + z * z - std::sin(radians(2 * turn)) * rc * y * z);
}

struct Sight {
    const char* name;
    Matrix matrix;  // for linear RGB
    double least;   // minimum CIEDE2000 between two types
};
constexpr Sight sights[] = {
    {"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 20},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}},
     13},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}},
     13},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}},
     8.5},
};

Triple seen(ImU32 color, const Matrix& sight) {
    Triple rgb = times(sight, linear(color));
    for (double& part : rgb)
        part = std::clamp(part, 0.0, 1.0);
    return lab(rgb);
}

class Themes : public ::testing::TestWithParam<Theme> {
protected:
    Themes() { theme::use(GetParam()); }
    ~Themes() override { theme::use(Theme::dark); }
};

TEST(Difference, IsThatOfThePublishedPairs) {
    EXPECT_NEAR(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
    EXPECT_NEAR(ciede2000({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
    EXPECT_NEAR(ciede2000({2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}), 0.9082, 1e-4);
    EXPECT_NEAR(contrast(theme::rgb(0xFFFFFF), theme::rgb(0)), 21, 1e-9);
}

struct Standing {
    const char* name;
    ImU32 color;
    std::vector<ImU32> grounds;
};

TEST_P(Themes, TextStandsOutFromItsGrounds) {
    using namespace theme;
    const std::vector<ImU32> all = {canvas, panel, bar, node, header, field, accent_soft};
    const std::vector<ImU32> plain = {canvas, panel, bar, node};
    const std::vector<ImU32> codes = {theme::code, code_highlight};
    const Standing texts[] = {
        {"text", text, all},
        {"dim", text_dim, all},
        {"accent", accent, all},
        {"warn", warn, plain},
        {"error", error, plain},
        {"ok", ok, plain},
        {"button", on_accent, {accent_fill}},
        {"code", code_text, codes},
        {"comment", code_comment, codes},
        {"keyword", code_keyword, codes},
        {"type", code_type, codes},
        {"function", code_function, codes},
        {"number", code_number, codes},
    };
    for (const Standing& each : texts)
        for (const ImU32 ground : each.grounds)
            EXPECT_GE(contrast(each.color, ground), 4.5)
                << each.name << " on " << std::hex << (ground & 0xFFFFFF);
}

TEST_P(Themes, PartsStandOutFromTheirGrounds) {
    using namespace theme;
    const Standing parts[] = {
        {"line", line, {canvas}},
        {"control", control, {canvas, panel, bar, node, header, field}},
        {"off", text_off, {panel, bar, node}},
    };
    for (const Standing& each : parts)
        for (const ImU32 ground : each.grounds)
            EXPECT_GE(contrast(each.color, ground), 2.995)
                << each.name << " on " << std::hex << (ground & 0xFFFFFF);
    for (unsigned i = 1; i <= port_type_count; ++i)
        for (const ImU32 ground : {canvas, node, header})
            EXPECT_GE(contrast(of(static_cast<PortType>(i)), ground), 2.995)
                << name_of(static_cast<PortType>(i));
}

TEST_P(Themes, TypesDifferForEverySight) {
    for (const Sight& sight : sights)
        for (unsigned i = 1; i <= port_type_count; ++i)
            for (unsigned k = 1; k < i; ++k) {
                const auto a = static_cast<PortType>(i), b = static_cast<PortType>(k);
                const double apart =
                    ciede2000(seen(theme::of(a), sight.matrix), seen(theme::of(b), sight.matrix));
                EXPECT_GE(apart, sight.least)
                    << name_of(a) << " and " << name_of(b) << ", " << sight.name;
            }
}

INSTANTIATE_TEST_SUITE_P(Both, Themes, ::testing::Values(Theme::dark, Theme::light),
                         [](const auto& each) {
                             return each.param == Theme::dark ? "dark" : "light";
                         });

}  // namespace
}  // namespace wrinkle::editor
