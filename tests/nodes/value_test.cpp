// Tests of nodes that reshape numbers, against hand-calculated numbers and means by samples.
#include <gtest/gtest.h>

#include "nodes/number.h"

namespace wrinkle::test {
namespace {

double at(const std::string& type, double x, const std::string& in, double width = 0) {
    return numbers_through(type, "value", in, "value", {x}, width)[0];
}

struct Reshaping {
    const char* type;
    double x;
    const char* in;
    double expected;
};

TEST(Value, HasItsFormula) {
    const Reshaping cases[] = {
        {"levels", 0.4, R"("in_low": 0.2, "in_high": 0.6)", 0.5},
        {"levels", 0.4, R"("in_low": 0.2, "in_high": 0.6, "gamma": 2)", 0.70710678},
        {"levels", 0.9, R"("in_low": 0.2, "in_high": 0.6, "out_low": 3, "out_high": 5)", 5},
        {"levels", 0.3, R"("in_low": 0.6, "in_high": 0.2)", 0.75},
        {"levels", 0.39, R"("in_low": 0.4, "in_high": 0.4)", 0},
        {"levels", 0.41, R"("in_low": 0.4, "in_high": 0.4)", 1},
        {"contrast", 0.7, R"("amount": 2)", 0.9},
        {"contrast", 0.7, R"("amount": 0, "pivot": 0.2)", 0.2},
        {"bias", 0.5, R"("bias": 0.3)", 0.3},
        {"bias", 0.25, R"("bias": 0.3)", 0.09},
        {"bias", -1, R"("bias": 0.3)", 0},
        {"gain", 0.25, R"("gain": 0.3)", 0.35},
        {"gain", 0.75, R"("gain": 0.3)", 0.65},
        {"gain", 0.5, R"("gain": 0.9)", 0.5},
        {"quantize", 0.6, R"("steps": 4, "smoothness": 0)", 0.5},
        {"quantize", 0.7375, R"("steps": 4, "smoothness": 0.1)", 0.625},
        {"quantize", -0.1, R"("steps": 4, "smoothness": 0)", -0.25},
        {"threshold", 0.49, "", 0},
        {"threshold", 0.51, "", 1},
        {"threshold", 0.45, R"("softness": 0.2)", 0.15625},
        {"ping_pong", 1.3, "", 0.7},
        {"ping_pong", -0.3, R"("scale": 0.5)", 0.3},
        {"ping_pong", 1.3, R"("scale": 0)", 0},
        {"wrap", 1.3, "", 0.3},
        {"wrap", -0.3, R"("low": 1, "high": 3)", 1.7},
        {"wrap", 0.7, R"("low": 2, "high": 2)", 2},
        {"invert", 0.3, "", 0.7},
        {"histogram_scan", 0.5, "", 0.5},
        {"histogram_scan", 0.7, R"("position": 0.5, "contrast": 0.5)", 0.9},
        {"histogram_scan", 0.99, R"("position": 0)", 0},
        {"histogram_scan", 0.01, R"("position": 1)", 1},
        {"histogram_scan", 0.51, R"("contrast": 1)", 1},
        {"histogram_scan", 0.49, R"("contrast": 1)", 0},
        {"histogram_range", 0.5, R"("range": 0.4, "position": 1)", 0.8},
        {"histogram_range", 0.5, R"("range": 0.4, "position": 0)", 0.2},
    };
    for (const Reshaping& c : cases)
        EXPECT_NEAR(at(c.type, c.x, c.in), c.expected, 1e-6) << c.type << " " << c.in;
}

// Far away the stairs are a straight line, through the mean of each step.
TEST(Quantize, FadesToItsMean) {
    const std::string in = R"("steps": 64, "smoothness": 0.2)";
    for (const double x : {0.31, 0.4, 0.77})
        EXPECT_NEAR(at("quantize", x, in, 0.25), x - 0.4 / 64, 1e-9);
}

// An edge in a pixel covers as much of the result as of the pixel.
TEST(Threshold, IsAtLeastAPixelWide) {
    EXPECT_NEAR(at("threshold", 0.5, "", 0.2), 0.5, 1e-9);
    EXPECT_GT(at("threshold", 0.55, "", 0.2), 0.6);
    EXPECT_LT(at("threshold", 0.55, "", 0.2), 0.95);
    EXPECT_NEAR(at("threshold", 0.61, "", 0.2), 1, 1e-9);
    EXPECT_NEAR(at("histogram_scan", 0.55, R"("contrast": 1)", 0.2), 0.75, 1e-9);
}

}  // namespace
}  // namespace wrinkle::test
