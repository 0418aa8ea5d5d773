// Tests of color adjustments against numbers of other programs, and of black bodies against
// Planck's law.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

const std::string blue = "\"color\": [0.2, 0.5, 0.8]";

std::vector<double> color(const std::string& type, const std::string& in,
                          const std::string& output = "color") {
    return value({one(type, blue + (in.empty() ? "" : ", " + in)), "n." + output});
}

struct Adjustment {
    const char* type;
    const char* in;
    std::vector<double> expected;
};

void expect_all(std::span<const Adjustment> cases, double tolerance) {
    for (const Adjustment& c : cases) {
        const auto got = color(c.type, c.in);
        for (size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(got[i], c.expected[i], tolerance) << c.type << " " << c.in << " " << i;
    }
}

// Blender 3.4.1: hue is 0.5 there where it is 0 here, contrast 50 percent is 2 here.
TEST(Color, HasTheNumbersOfBlender) {
    const Adjustment cases[] = {
        {"hsv_adjust", "\"hue\": 0.1", {0.26, 0.2, 0.8}},
        {"hsv_adjust", "\"saturation\": 0.5", {0.5, 0.65, 0.8}},
        {"hsv_adjust", "\"saturation\": 1.5, \"value\": 1.2", {0, 0.42, 0.96}},
        {"brightness_contrast", "\"contrast\": 2", {-0.1, 0.5, 1.1}},
        {"color_gamma", "\"gamma\": 2.2", {0.028991, 0.217638, 0.612066}},
    };
    expect_all(cases, 1e-5);
    EXPECT_NEAR(color("luminance", "", "value")[0], 0.45788, 1e-5);
}

TEST(Color, HasItsFormula) {
    const Adjustment cases[] = {
        {"color", "", {0.2, 0.5, 0.8}},
        {"exposure", "\"stops\": 1", {0.4, 1, 1.6}},
        {"exposure", "\"stops\": -1", {0.1, 0.25, 0.4}},
        {"invert_color", "", {0.8, 0.5, 0.2}},
        {"saturation", "\"amount\": 0", {0.45788, 0.45788, 0.45788}},
        {"saturation", "\"amount\": 2", {-0.05788, 0.54212, 1.14212}},
        {"color_correct", "", {0.2, 0.5, 0.8}},
        {"color_correct", "\"gamma\": 2", {0.447214, 0.707107, 0.894427}},
        {"color_correct", "\"lift\": 0.5", {0.6, 0.75, 0.9}},
        // 0.2, 0.5, 0.8 with gain 0.5, then contrast 2 around 0.25, then one stop.
        {"color_correct",
         "\"gain\": 0.5, \"contrast\": 2, \"pivot\": 0.25, \"exposure\": 1",
         {-0.1, 0.5, 1.1}},
        {"color_correct", "\"hue\": 0.1, \"saturation\": 0", {0.256076, 0.256076, 0.256076}},
        {"oklch_adjust", "", {0.2, 0.5, 0.8}},
    };
    expect_all(cases, 1e-5);
}

// B. Ottosson 2020.
TEST(Oklab, HasThePublishedNumbers) {
    const std::pair<const char*, std::array<double, 3>> table[] = {
        {"[1, 1, 1]", {1, 0, 0}},
        {"[1, 0, 0]", {0.627955, 0.224863, 0.125846}},
        {"[0, 1, 0]", {0.866440, -0.233888, 0.179498}},
        {"[0, 0, 1]", {0.452014, -0.032457, -0.311528}},
        {"[0.2, 0.5, 0.8]", {0.766887, -0.046271, -0.077996}},
    };
    for (const auto& [rgb, lab] : table) {
        const std::string in = std::string("\"color\": ") + rgb;
        const auto got = value({one("to_oklab", in), "n.lab"});
        const auto back =
            value({one("to_oklab", in) +
                       R"(, "b": {"type": "from_oklab", "in": {"lab": {"from": "n.lab"}}})",
                   "b.color"});
        const auto same = value({one("color", in), "n.color"});
        for (size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(got[i], lab[i], 1e-5) << rgb;
            EXPECT_NEAR(back[i], same[i], 1e-5) << rgb;
        }
    }
}

TEST(Oklch, ChangesOneQuality) {
    const auto lab_of = [](const std::string& in) {
        return value({one("oklch_adjust", blue + ", " + in) +
                          R"(, "b": {"type": "to_oklab", "in": {"color": {"from": "n.color"}}})",
                      "b.lab"});
    };
    const auto lighter = lab_of("\"lightness\": 1.1"), duller = lab_of("\"chroma\": 0.5"),
               turned = lab_of("\"hue\": 0.25");
    EXPECT_NEAR(lighter[0], 0.8435757, 1e-5);
    EXPECT_NEAR(lighter[1], -0.046271, 1e-5);
    EXPECT_NEAR(duller[0], 0.766887, 1e-5);
    EXPECT_NEAR(duller[2], -0.038998, 1e-5);
    EXPECT_NEAR(turned[1], 0.077996, 1e-5);
    EXPECT_NEAR(turned[2], -0.046271, 1e-5);
}

// The color matching functions of CIE 1931 as sums of Gaussians (C. Wyman 2013).
double lobe(double x, double mean, double below, double above) {
    const double t = (x - mean) / (x < mean ? below : above);
    return std::exp(-t * t / 2);
}
std::array<double, 3> planck_chromaticity(double kelvin) {
    double x = 0, y = 0, z = 0;
    for (double nm = 360; nm <= 830; nm += 1) {
        const double m = nm * 1e-9;
        const double power = 1 / (std::pow(m, 5) * std::expm1(1.438776877e-2 / (m * kelvin)));
        x += power * (1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442, 16, 26.7) -
                      0.065 * lobe(nm, 501.1, 20.4, 26.2));
        y += power * (0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1));
        z += power * (1.217 * lobe(nm, 437, 11.8, 36) + 0.681 * lobe(nm, 459, 26, 13.8));
    }
    return {x / (x + y + z), y / (x + y + z), z / (x + y + z)};
}

TEST(Blackbody, IsThatOfPlancksLaw) {
    for (const double kelvin : {2000.0, 2856.0, 4000.0, 5000.0, 6500.0, 9000.0, 12000.0}) {
        const auto rgb =
            value({one("blackbody", "\"temperature\": " + std::to_string(kelvin)), "n.color"});
        EXPECT_NEAR(0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2], 1, 1e-5);
        const double x = 0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2];
        const double y = 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2];
        const double z = 0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2];
        const auto expected = planck_chromaticity(kelvin);
        EXPECT_NEAR(x / (x + y + z), expected[0], 4e-3) << kelvin;
        EXPECT_NEAR(y / (x + y + z), expected[1], 4e-3) << kelvin;
    }
}

}  // namespace
}  // namespace wrinkle::test
