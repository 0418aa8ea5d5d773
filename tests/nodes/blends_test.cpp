// Tests of blend methods of other programs against the exact sum of heights; the expected figures
// are the published ones.
#include <gtest/gtest.h>

#include <ostream>

#include "nodes/normals.h"

namespace wrinkle::test {
namespace {

constexpr size_t count = 4000;  // sample count of the published maxima
const std::vector<Pair>& pairs() {
    static const std::vector<Pair> drawn = random_pairs(count, 45);
    return drawn;
}

// Bump over bump with the nodes of this project.
std::string layered(const char* base, const char* detail) {
    const auto bump = [](const std::string& id, const std::string& from) {
        return "\"" + id +
               R"(": {"type": "gradient_from_tangent_normal", "in": {"normal": {"from": ")" + from +
               R"("}, "frame": "vertex"}}, )";
    };
    return bump("a", base) + bump("b", detail) +
           R"("sum": {"type": "gradient_add", "in": {"a": {"from": "a.gradient"},
                      "b": {"from": "b.gradient"}}},
              "n": {"type": "resolve", "in": {"gradient": {"from": "sum.gradient"}}})";
}

TEST(Gradients, AreTheHeightsAddedUp) {
    const auto ours = read(layered("surface.position", "surface.view"), "n.normal", pairs());
    EXPECT_LE(angles(ours, sums(pairs())).max, 1e-6);
    const auto other = read(layered("surface.view", "surface.position"), "n.normal", pairs());
    EXPECT_LE(angles(ours, other).max, 1e-6);
}

struct Blend {
    const char* type;
    const char* in;
    Angles from_sum;                // tilts up to 45 degrees
    double flat_detail, flat_base;  // maximum change caused by a flat layer
    double order, grouping;         // maximum changes; grouping with tilts up to 60 degrees
};
void PrintTo(const Blend& blend, std::ostream* out) {
    *out << blend.type << " " << blend.in;
}

// Compares maxima over different sets of random angles.
void expect_most(double got, double published) {
    if (published == 0) {
        EXPECT_LE(got, 1e-6);
        return;
    }
    EXPECT_GE(got, published * 0.8);
    EXPECT_LE(got, published * 1.25);
}

class Blends : public testing::TestWithParam<Blend> {};

TEST_P(Blends, AreAsFarOffAsPublished) {
    const auto& blend = GetParam();
    const Angles got = angles(blended(blend.type, blend.in, pairs()), sums(pairs()));
    EXPECT_NEAR(got.mean, blend.from_sum.mean, 0.3);
    expect_most(got.max, blend.from_sum.max);
}

TEST_P(Blends, WithAFlatLayer) {
    const auto& blend = GetParam();
    std::vector<Pair> flat_detail, flat_base;
    std::vector<Normal> alone;
    for (int tilt = 0; tilt <= 45; ++tilt)
        for (int azimuth = 0; azimuth < 360; azimuth += 5) {
            alone.push_back(tilted(tilt, azimuth));
            flat_detail.push_back({alone.back(), {0, 0, 1}});
            flat_base.push_back({{0, 0, 1}, alone.back()});
        }
    EXPECT_NEAR(angles(blended(blend.type, blend.in, flat_detail), alone).max, blend.flat_detail,
                0.05);
    EXPECT_NEAR(angles(blended(blend.type, blend.in, flat_base), alone).max, blend.flat_base, 0.05);
}

TEST_P(Blends, InAnotherOrder) {
    const auto& blend = GetParam();
    const auto one = blended(blend.type, blend.in, pairs());
    expect_most(angles(one, blended(blend.type, blend.in, swapped(pairs()))).max, blend.order);
}

TEST_P(Blends, InAnotherGrouping) {
    const auto& blend = GetParam();
    const auto steep = random_pairs(count, 60);
    expect_most(angles(blended_left(blend.type, steep), blended_right(blend.type, steep)).max,
                blend.grouping);
}

// Measured once on as many random pairs; the maximum varies between draws, the mean hardly.
INSTANTIATE_TEST_SUITE_P(
    Table, Blends,
    testing::Values(Blend{"compare_linear", "", {14.25, 22.48}, 22.5, 22.5, 0, 28.1},
                    Blend{"compare_overlay", "", {6.71, 30.24}, 9.73, 9.73, 50.8, 35.6},
                    Blend{"compare_partial_derivative", "", {0, 0}, 0, 0, 0, 0},
                    Blend{"compare_whiteout", "", {2.08, 9.02}, 0, 0, 0, 63.1},
                    Blend{"compare_udn", "", {2.01, 10.59}, 0, 9.73, 9.7, 33.5},
                    Blend{"compare_rnm", "", {3.05, 24.97}, 0, 0, 17.2, 26.9},
                    Blend{"compare_unity", "", {5.72, 31.94}, 0, 0, 50.7, 112.8}));

// One tilt of the base and one of the detail, at every pair of azimuths.
struct Tilts {
    const char* type;
    const char* in;
    double base, detail;
    Angles published;
};
void PrintTo(const Tilts& tilts, std::ostream* out) {
    *out << tilts.type << " " << tilts.base << " + " << tilts.detail;
}

class AzimuthPairs : public testing::TestWithParam<Tilts> {};

TEST_P(AzimuthPairs, AreAsFarOffAsPublished) {
    const Tilts& tilts = GetParam();
    std::vector<Pair> all;
    for (int base = 0; base < 360; base += 5)
        for (int detail = 0; detail < 360; detail += 5)
            all.push_back({tilted(tilts.base, base), tilted(tilts.detail, detail)});
    const Angles got = angles(blended(tilts.type, tilts.in, all), sums(all));
    EXPECT_NEAR(got.mean, tilts.published.mean, 0.1);
    EXPECT_NEAR(got.max, tilts.published.max, 0.1);
}

std::vector<Tilts> azimuth_table() {
    struct Column {
        const char* type;
        const char* in;
        Angles at[4];
    };
    const double tilts[4][2] = {{15, 15}, {30, 30}, {45, 30}, {60, 30}};
    const char* babylon = R"("blue": "product")";
    const Column columns[] = {
        {"compare_overlay", babylon, {{2.1, 4.1}, {7.5, 18.6}, {8.5, 20.5}, {7.8, 14.3}}},
        {"compare_whiteout", "", {{0.6, 0.8}, {3.4, 4.1}, {6.3, 7.5}, {10.3, 14.3}}},
        {"compare_udn", "", {{0, 0}, {0, 0}, {4.4, 6.6}, {9.7, 14.2}}},
        {"compare_linear", "", {{8.8, 13.2}, {14.4, 19.1}, {19.3, 20.6}, {27.1, 34.1}}},
        {"compare_rnm", "", {{0.8, 1.8}, {4.9, 10.9}, {10.5, 17.4}, {17.8, 23.4}}},
        {"compare_nested_frame", "", {{0.5, 0.5}, {3.5, 5.1}, {8, 12.5}, {13.3, 20.3}}},
        {"compare_bump_over_normal", "", {{1, 2.3}, {7.1, 14.6}, {16.3, 26.6}, {30.1, 42.5}}}};
    std::vector<Tilts> table;
    for (const Column& column : columns)
        for (size_t i = 0; i < 4; ++i)
            table.push_back({column.type, column.in, tilts[i][0], tilts[i][1], column.at[i]});
    return table;
}
INSTANTIATE_TEST_SUITE_P(Table, AzimuthPairs, testing::ValuesIn(azimuth_table()));

}  // namespace
}  // namespace wrinkle::test
