// Tests of blends against pixels of Chromium's canvas and numbers of Blender's compositor.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/blender_numbers.h"
#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

using Color3 = std::array<double, 3>;

std::string list(const Color3& c) {
    return "[" + std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]) +
           "]";
}

std::vector<double> blended(const Color3& base, const Color3& top, const std::string& mode,
                            const std::string& more = "") {
    return value({one("blend", "\"base\": " + list(base) + ", \"top\": " + list(top) +
                                   ", \"mode\": \"" + mode + "\"" + more),
                  "n.color"});
}

// The curve of IEC 61966-2-1, and its inverse.
double linear_of(double byte) {
    const double x = byte / 255;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}
double byte_of(double x) {
    return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}
Color3 linear_of(const Color3& bytes) {
    return {linear_of(bytes[0]), linear_of(bytes[1]), linear_of(bytes[2])};
}

struct Pixel {
    const char* mode;
    Color3 bytes;
};

void expect_bytes(const Color3& base, const Color3& top, const std::vector<Pixel>& pixels) {
    for (const auto& [mode, bytes] : pixels) {
        const auto got = blended(linear_of(base), linear_of(top), mode, R"(, "space": "display")");
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(byte_of(got[c]), bytes[c], 1.0) << mode << " " << c;
    }
}

// globalCompositeOperation of headless Chromium.
TEST(Blend, HasThePixelsOfACanvas) {
    expect_bytes({51, 128, 204}, {153, 77, 230},
                 {{"multiply", {31, 39, 184}},
                  {"screen", {173, 166, 250}},
                  {"overlay", {61, 78, 245}},
                  {"darken", {51, 77, 204}},
                  {"lighten", {153, 128, 230}},
                  {"color_dodge", {128, 183, 255}},
                  {"color_burn", {0, 0, 198}},
                  {"hard_light", {92, 77, 245}},
                  {"soft_light", {64, 103, 223}},
                  {"difference", {102, 51, 26}},
                  {"exclusion", {142, 127, 66}},
                  {"hue", {150, 74, 227}},
                  {"saturation", {51, 128, 204}},
                  {"color", {150, 74, 227}},
                  {"luminosity", {54, 131, 207}}});
    expect_bytes({26, 64, 242}, {128, 200, 13},
                 {{"color_burn", {0, 11, 0}},
                  {"soft_light", {26, 100, 231}},
                  {"hue", {57, 93, 0}},
                  {"saturation", {32, 65, 219}},
                  {"luminosity", {131, 153, 255}}});
}

// On linear values, without clamping.
TEST(Blend, HasTheNumbersOfBlender) {
    for (const auto& [mode, base, top, color] : blender_blends) {
        const auto got = blended(base, top, mode, R"(, "clamp": false)");
        const auto half = blended(base, top, mode, R"(, "clamp": false, "opacity": 0.5)");
        for (size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(got[c], color[c], 1e-5) << mode;
            EXPECT_NEAR(half[c], (base[c] + color[c]) / 2, 1e-5) << mode;
        }
    }
}

// Modes that neither has, on numbers where each takes both of its branches.
TEST(Blend, HasTheModesOfPhotoshop) {
    const Color3 base{0.2, 0.5, 0.8}, top{0.6, 0.3, 0.9};
    const std::pair<const char*, Color3> expected[] = {
        {"normal", {0.6, 0.3, 0.9}},    {"add", {0.8, 0.8, 1}},
        {"subtract", {0, 0.2, 0}},      {"vivid_light", {0.25, 0.166667, 1}},
        {"pin_light", {0.2, 0.5, 0.8}}, {"hard_mix", {0, 0, 1}},
        {"linear_burn", {0, 0, 0.7}},
    };
    for (const auto& [mode, numbers] : expected) {
        const auto got = blended(base, top, mode);
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], numbers[c], 1e-5) << mode << " " << c;
    }
    EXPECT_NEAR(blended({0.9, 0, 0}, {0.3, 0, 0}, "pin_light")[0], 0.6, 1e-6);
    EXPECT_NEAR(blended({0.1, 0, 0}, {0.9, 0, 0}, "pin_light")[0], 0.8, 1e-6);
}

TEST(Blend, OfBlackAndWhiteIsDefined) {
    for (const double base : {0.0, 1.0})
        for (const double top : {0.0, 1.0}) {
            const auto dodge = blended({base, base, base}, {top, top, top}, "color_dodge");
            const auto burn = blended({base, base, base}, {top, top, top}, "color_burn");
            EXPECT_EQ(dodge[0], base) << top;
            EXPECT_EQ(burn[0], base) << top;
        }
    EXPECT_EQ(blended({0.3, 0.3, 0.3}, {0, 0, 0}, "divide")[0], 0);
    for (const char* mode : {"hue", "saturation", "color", "luminosity"})
        EXPECT_NEAR(blended({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, mode)[0], 0.5, 1e-12) << mode;
}

TEST(Blend, WithoutItsMaskIsTheBase) {
    const Color3 base{0.2, 0.5, 1.8}, top{0.6, 0.3, 0.9};
    for (const char* strength : {", \"mask\": 0", ", \"opacity\": 0"}) {
        const auto got = blended(base, top, "multiply", strength);
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], base[c], 1e-12);
    }
}

double number_blend(double base, double top, const std::string& mode,
                    const std::string& more = "") {
    return value({one("float_blend", "\"base\": " + std::to_string(base) +
                                         ", \"top\": " + std::to_string(top) + ", \"mode\": \"" +
                                         mode + "\"" + more),
                  "n.value"})[0];
}

TEST(FloatBlend, HasItsFormulas) {
    EXPECT_NEAR(number_blend(0.3, 0.8, "normal"), 0.8, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "add"), 1.1, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "add", ", \"clamp\": true"), 1, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "subtract"), -0.5, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "multiply"), 0.24, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "minimum"), 0.3, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "maximum"), 0.8, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "screen"), 0.86, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "overlay"), 0.48, 1e-6);
    EXPECT_NEAR(number_blend(0.3, 0.8, "normal", ", \"mask\": 0.5, \"opacity\": 0.5"), 0.425, 1e-6);
}

// A quarter of the band where the numbers are equal; nothing outside the band.
TEST(FloatBlend, RoundsTheCreaseOfExtrema) {
    const std::string band = ", \"smoothness\": 0.2";
    EXPECT_NEAR(number_blend(0.5, 0.5, "smooth_minimum", band), 0.45, 1e-6);
    EXPECT_NEAR(number_blend(0.5, 0.5, "smooth_maximum", band), 0.55, 1e-6);
    EXPECT_NEAR(number_blend(0.5, 0.6, "smooth_minimum", band), 0.4875, 1e-6);
    EXPECT_NEAR(number_blend(0.5, 0.7, "smooth_minimum", band), 0.5, 1e-6);
    EXPECT_NEAR(number_blend(0.5, 0.7, "smooth_maximum", band), 0.7, 1e-6);
    EXPECT_NEAR(number_blend(0.5, 0.5, "smooth_minimum", ", \"smoothness\": 0"), 0.5, 1e-6);
}

}  // namespace
}  // namespace wrinkle::test
