// Tests of random numbers: distribution, independence of neighbours, and palettes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

constexpr int row_length = 320;  // 102,400 cells

// The numbers of all cells, row by row; `lane` of the output.
std::vector<double> of_cells(const std::string& type, const std::string& in,
                             const std::string& output, size_t lane = 0) {
    std::vector<std::array<double, 2>> cells;
    for (int y = 0; y < row_length; ++y)
        for (int x = 0; x < row_length; ++x)
            cells.push_back({x - 100.0, y - 37.0});
    const std::string wire = R"("cell": {"from": "surface.uv0"})";
    std::vector<double> numbers;
    for (const auto& lanes :
         values({one(type, wire + (in.empty() ? "" : ", " + in)), "n." + output}, cells))
        numbers.push_back(lanes[lane]);
    return numbers;
}

double mean_of(const std::vector<double>& numbers) {
    double sum = 0;
    for (const double each : numbers)
        sum += each;
    return sum / static_cast<double>(numbers.size());
}
double covariance(const std::vector<double>& a, const std::vector<double>& b, size_t shift) {
    const double mean_a = mean_of(a), mean_b = mean_of(b);
    double sum = 0;
    for (size_t i = 0; i + shift < a.size(); ++i)
        sum += (a[i] - mean_a) * (b[i + shift] - mean_b);
    return sum / static_cast<double>(a.size() - shift);
}

void expect_uniform(const std::vector<double>& numbers) {
    EXPECT_NEAR(mean_of(numbers), 0.5, 0.005);
    const double variance = covariance(numbers, numbers, 0);
    EXPECT_NEAR(variance, 1 / 12.0, 0.001);
    for (const size_t shift :
         {size_t{1}, size_t{row_length}, size_t{row_length + 1}, size_t{row_length - 1}})
        EXPECT_LT(std::fabs(covariance(numbers, numbers, shift)) / variance, 0.02);
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    EXPECT_GE(*least, 0);
    EXPECT_LT(*most, 1);
}

TEST(Random, IsUniformAndWithoutCorrelation) {
    const auto value = of_cells("random", "", "value");
    expect_uniform(value);
    std::vector<std::vector<double>> all{value, of_cells("random", "\"seed\": 1", "value"),
                                         of_cells("random", "\"id\": 1", "value")};
    for (size_t lane = 0; lane < 3; ++lane) {
        all.push_back(of_cells("random", "", "vector", lane));
        expect_uniform(all.back());
    }
    for (size_t a = 0; a < all.size(); ++a)
        for (size_t b = 0; b < a; ++b)
            EXPECT_LT(std::fabs(covariance(all[a], all[b], 0)) * 12, 0.02) << a << " " << b;
}

TEST(Random, IsConstantInACell) {
    const std::string in = R"("cell": {"from": "surface.uv0"})";
    const Scene scene{one("random", in), "n.value"};
    const auto got = values(scene, {{3, 7}, {3.4, 6.6}, {2.6, 7.4}, {3.6, 7}, {-3, 7}});
    EXPECT_EQ(got[0], got[1]);
    EXPECT_EQ(got[0], got[2]);
    EXPECT_NE(got[0], got[3]);
    EXPECT_NE(got[0], got[4]);
}

TEST(Random, FadesToItsMean) {
    for (const auto& [output, lanes] : {std::pair{"value", 1}, std::pair{"color", 3}}) {
        const auto got =
            value({one("random", "\"cell\": [3, 4], \"detail\": 0"), std::string("n.") + output});
        for (int c = 0; c < lanes; ++c)
            EXPECT_EQ(got[static_cast<size_t>(c)], 0.5);
    }
}

TEST(RandomRange, IsBetweenItsBounds) {
    const auto numbers = of_cells("random_range", "\"low\": -2, \"high\": 4", "value");
    EXPECT_NEAR(mean_of(numbers), 1, 0.03);
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    EXPECT_GE(*least, -2);
    EXPECT_LT(*least, -1.99);
    EXPECT_LT(*most, 4);
}

// The mean that the color fades to is that of its cells, for full and narrow ranges of hue.
TEST(RandomColor, FadesToItsMean) {
    for (const char* hues : {"0, \"hue_high\": 1", "0.05, \"hue_high\": 0.21",
                             "0.9, \"hue_high\": 1.4", "0.3, \"hue_high\": 0.3"}) {
        const std::string in = std::string("\"hue_low\": ") + hues;
        const auto far = value({one("random_color", in + ", \"detail\": 0"), "n.color"});
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(mean_of(of_cells("random_color", in, "color", c)), far[c], 0.004) << hues;
    }
}

TEST(RandomDirection, IsEvenOverTheSphere) {
    std::vector<std::vector<double>> lanes;
    for (size_t c = 0; c < 3; ++c)
        lanes.push_back(of_cells("random_direction", "", "vector", c));
    for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(mean_of(lanes[c]), 0, 0.006);
        EXPECT_NEAR(covariance(lanes[c], lanes[c], 0), 1 / 3.0, 0.005);
    }
    for (size_t i = 0; i < 100; ++i)
        EXPECT_NEAR(std::hypot(lanes[0][i], lanes[1][i], lanes[2][i]), 1, 1e-9);
}

const std::string three_colors =
    R"("colors": 3, "color_1": [1, 0, 0], "color_2": [0, 1, 0], "color_3": [0, 0, 1],
       "weight_1": 1, "weight_2": 2, "weight_3": 1, "random": )";

TEST(Palette, ChoosesByWeight) {
    const std::pair<const char*, size_t> choices[] = {{"-1", 0},   {"0", 0},    {"0.24", 0},
                                                      {"0.26", 1}, {"0.74", 1}, {"0.76", 2},
                                                      {"1", 2},    {"9", 2}};
    for (const auto& [random, chosen] : choices) {
        const auto got = value({one("palette", three_colors + random), "n.color"});
        for (size_t c = 0; c < 3; ++c)
            EXPECT_EQ(got[c], c == chosen ? 1 : 0) << random;
    }
    const auto mean = value({one("palette", three_colors + "0, \"detail\": 0"), "n.color"});
    EXPECT_NEAR(mean[0], 0.25, 1e-9);
    EXPECT_NEAR(mean[1], 0.5, 1e-9);
    EXPECT_NEAR(mean[2], 0.25, 1e-9);
}

}  // namespace
}  // namespace wrinkle::test
