// Tests of nodes that bend texture coordinates, at points with known images.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

void expect_uv(const std::string& type, const std::string& in, std::array<double, 2> at,
               std::array<double, 2> expected) {
    const auto got = value({one(type, in), "n.uv"}, at[0], at[1]);
    for (size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(got[i], expected[i], 1e-6) << type << " " << in;
}

TEST(UvTools, MoveKnownPoints) {
    expect_uv("uv_rotate", "\"angle\": 90", {0.7, 0.5}, {0.5, 0.7});
    expect_uv("uv_rotate", "\"angle\": 90, \"center\": [0, 0]", {1, 2}, {-2, 1});
    expect_uv("uv_mirror", "", {0.2, 0.3}, {0.8, 0.3});
    expect_uv("uv_mirror", R"("mirror_u": false, "mirror_v": true)", {0.2, 0.3}, {0.2, 0.7});
    expect_uv("uv_shear", "\"amount\": [0.5, 0]", {0.2, 0.9}, {0.4, 0.9});
    expect_uv("uv_tile", "", {2.25, -0.75}, {0.25, 0.25});
    // At half of the radius a quarter of the angle is left.
    expect_uv("uv_swirl", "\"angle\": 360", {0.75, 0.5}, {0.5, 0.75});
    expect_uv("uv_swirl", "", {0.5, 0.5}, {0.5, 0.5});
    expect_uv("uv_swirl", "", {1.1, 0.5}, {1.1, 0.5});
    // (1 - 0.25)^2 / 2 less of 0.25.
    expect_uv("uv_spherize", "", {0.75, 0.5}, {0.5 + 0.25 * (1 - 0.28125), 0.5});
    expect_uv("uv_spherize", "", {1.1, 0.5}, {1.1, 0.5});
    expect_uv("uv_polar", "", {0.5, 0.9}, {0.4, 0.25});
    expect_uv("uv_polar", "\"scale\": 2, \"repeat\": 4", {0.5, 0.1}, {0.8, -1});
    expect_uv("uv_polar", "", {0.5, 0.5}, {0, 0});
    expect_uv("uv_warp", "\"vector\": [1, 0.25]", {0.3, 0.6}, {0.4, 0.55});
    expect_uv("uv_warp_directional", R"("value": 0.5, "middle": 1, "angle": 90)", {0.3, 0.6},
              {0.3, 0.55});
}

// All points of a kaleidoscope that differ by a sector, or are mirrored, read one point.
TEST(UvTools, KaleidoscopesRepeatASector) {
    const auto at = [](double angle) {
        return value({one("uv_kaleidoscope", "\"segments\": 5"), "n.uv"},
                     0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
    };
    const double sector = 2 * std::acos(-1) / 5;
    for (const double angle : {0.1, 0.5, 0.62}) {
        const auto first = at(angle);
        EXPECT_NEAR(first[0], 0.5 + 0.3 * std::cos(angle), 1e-6);
        for (int k = 0; k < 5; ++k)
            for (const double sign : {-1.0, 1.0})
                for (size_t i = 0; i < 2; ++i)
                    EXPECT_NEAR(at(sign * angle + k * sector)[i], first[i], 1e-6);
    }
}

// The bowl 0.5 (x^2 + 3 y^2) has the slope (x, 3 y), and so have its central differences.
const char bowl[] = R"("u": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
    "xx": {"type": "multiply", "in": {"a": {"from": "u.x"}, "b": {"from": "u.x"}}},
    "yy": {"type": "multiply", "in": {"a": {"from": "u.y"}, "b": {"from": "u.y"}}},
    "y3": {"type": "multiply", "in": {"a": {"from": "yy.result"}, "b": 1.5}},
    "bowl": {"type": "multiply_add", "in": {"a": {"from": "xx.result"}, "b": 0.5,
        "c": {"from": "y3.result"}}}, )";

TEST(UvWarpSlope, MovesUphill) {
    const std::string nodes =
        bowl + one("uv_warp_slope", R"("value": {"from": "bowl.result"}, "amount": 0.2)");
    const std::string downhill =
        bowl + one("uv_warp_slope", R"("value": {"from": "bowl.result"}, "amount": -0.1,
            "span": 0.3)");
    for (const auto& [x, y] : {std::pair{0.3, 0.6}, {-1.2, 0.1}}) {
        const auto up = value({nodes, "n.uv"}, x, y), slope = value({nodes, "n.slope"}, x, y),
                   down = value({downhill, "n.uv"}, x, y);
        EXPECT_NEAR(slope[0], x, 1e-9);
        EXPECT_NEAR(slope[1], 3 * y, 1e-9);
        EXPECT_NEAR(up[0], 1.2 * x, 1e-9);
        EXPECT_NEAR(up[1], 1.6 * y, 1e-9);
        EXPECT_NEAR(down[0], 0.9 * x, 1e-9);
        EXPECT_NEAR(down[1], 0.7 * y, 1e-9);
    }
}

// A relief that is read there has the slope of central differences.
TEST(UvWarpSlope, HasAnExactSlope) {
    constexpr double step = 1e-5;
    const std::string nodes =
        R"("w": {"type": "waves", "in": {"scale": 3}}, )" +
        one("uv_warp_slope", R"("value": {"from": "w.value"}, "span": 0.02, "amount": 0.01)") +
        R"(, "r": {"type": "waves", "in": {"uv": {"from": "n.uv"}, "amplitude": 0.1}},
        "g": {"type": "gradient_from_height", "in": {"height": {"from": "r.height"}}})";
    for (const std::array<double, 2>& p : {std::array{0.31, 0.62}, {0.87, -0.4}, {-2.3, 1.9}}) {
        const auto at = [&](double dx, double dy) {
            return value({nodes, "r.height"}, p[0] + dx, p[1] + dy)[0];
        };
        const auto slope = value({nodes, "g.gradient"}, p[0], p[1]);
        EXPECT_NEAR(slope[0], (at(step, 0) - at(-step, 0)) / (2 * step), 1e-6);
        EXPECT_NEAR(slope[1], (at(0, step) - at(0, -step)) / (2 * step), 1e-6);
        EXPECT_GT(std::fabs(slope[0]) + std::fabs(slope[1]), 0.05);
    }
}

// The eight ways to turn and flip a square all occur, and each is one of the square.
TEST(UvTools, TilesTurnAndFlip) {
    const std::string tile = one("uv_tile", R"("flip": true, "turn": true)");
    std::set<std::array<int, 2>> seen;
    for (int k = 0; k < 200; ++k) {
        const auto uv = value({tile, "n.uv"}, k + 0.1, 0.3),
                   cell = value({tile, "n.cell"}, k + 0.1, 0.3);
        EXPECT_EQ(cell[0], k);
        seen.insert(
            {static_cast<int>(std::lround(uv[0] * 10)), static_cast<int>(std::lround(uv[1] * 10))});
    }
    EXPECT_EQ(seen, (std::set<std::array<int, 2>>{
                        {1, 3}, {9, 3}, {9, 7}, {1, 7}, {3, 1}, {7, 1}, {3, 9}, {7, 9}}));
}

}  // namespace
}  // namespace wrinkle::test
