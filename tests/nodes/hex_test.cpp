// Tests of hex tiling: the rotated and shifted copies remain one consistent texture, with slopes
// rotated accordingly.
#include <gtest/gtest.h>

#include <cmath>

#include "nodes/plane.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

double hex_waves(double u, double v) {
    return 0.5 + 0.2 * std::sin(full_circle * u) + 0.15 * std::cos(full_circle * (v + 0.1)) +
           0.1 * std::sin(full_circle * (u + v));
}
const Image heights = painted(256, [](double u, double v) {
    return std::array{hex_waves(u, v), hex_waves(u, v), hex_waves(u, v)};
});
// The normal map of the relief 0.1 hex_waves, encoded.
const Image normals = painted(256, [](double u, double v) {
    constexpr double step = 1e-5;
    const double x = 0.1 * (hex_waves(u + step, v) - hex_waves(u - step, v)) / (2 * step);
    const double y = 0.1 * (hex_waves(u, v + step) - hex_waves(u, v - step)) / (2 * step);
    const double k = 0.5 / std::sqrt(1 + x * x + y * y);
    return std::array{0.5 - x * k, 0.5 - y * k, 0.5 + k};
});

// Around the centres of hexagons (of a grid of side 1 / (2 sqrt 3)) only one hexagon contributes.
std::vector<std::array<double, 2>> near_centres() {
    std::vector<std::array<double, 2>> points;
    for (int i = -6; i <= 6; ++i)
        for (int j = -6; j <= 6; ++j) {
            const double u = (i + 0.5 * j) / 3.4641016151377544;
            const double v = j * 0.8660254037844386 / 3.4641016151377544;
            points.push_back({u + 0.01, v - 0.007});
        }
    return points;
}

std::vector<std::array<double, 2>> moved(std::vector<std::array<double, 2>> points, double u,
                                         double v) {
    for (auto& point : points)
        point = {point[0] + u, point[1] + v};
    return points;
}

const std::string hex_relief = one("hex_tile_height_map", R"("amplitude": 0.1)");

std::array<std::vector<std::vector<double>>, 4> around(const Scene& scene, double step) {
    const auto centres = near_centres();
    return {values(scene, moved(centres, step, 0)), values(scene, moved(centres, -step, 0)),
            values(scene, moved(centres, 0, step)), values(scene, moved(centres, 0, -step))};
}

TEST(Pitfall24HexRotation, SlopesAreThoseOfTheTurnedRelief) {
    constexpr double step = 0.006;
    const auto [right, left, above, below] = around({hex_relief, "n.height", heights}, step);
    const auto of_height = values({hex_relief, "n.gradient", heights}, near_centres());
    const auto of_normal =
        values({one("hex_tile_normal_map"), "n.gradient", normals}, near_centres());
    double steepest = 0;
    for (size_t i = 0; i < of_height.size(); ++i) {
        const double du = (right[i][0] - left[i][0]) / (2 * step);
        const double dv = (above[i][0] - below[i][0]) / (2 * step);
        EXPECT_NEAR(of_height[i][0], du, 3e-3);
        EXPECT_NEAR(of_height[i][1], dv, 3e-3);
        EXPECT_NEAR(of_normal[i][0], du, 3e-3);
        EXPECT_NEAR(of_normal[i][1], dv, 3e-3);
        steepest = std::fmax(steepest, std::hypot(du, dv));
    }
    EXPECT_GT(steepest, 0.15);
}

// Each copy has a different rotation: the directions of slopes cover the circle.
TEST(Pitfall24HexRotation, CopiesAreTurnedAndMoved) {
    const Image ramp = painted(8, [](double, double) { return std::array{0.3, 0.5, 0.9}; });
    int sectors[8] = {};
    for (const auto& g : values({one("hex_tile_normal_map"), "n.gradient", ramp}, near_centres()))
        ++sectors[static_cast<int>((std::atan2(g[1], g[0]) / full_circle + 0.5) * 7.999)];
    for (const int count : sectors)
        EXPECT_GT(count, 5);
    const std::string unturned = one("hex_tile_normal_map", R"("rotation": 0)");
    for (const auto& g : values({unturned, "n.gradient", ramp}, near_centres())) {
        EXPECT_NEAR(g[0], 0.5, 1e-5);
        EXPECT_NEAR(g[1], 0, 1e-5);
    }
    const auto here = values({hex_relief, "n.height", heights}, near_centres());
    const auto next = values({hex_relief, "n.height", heights}, moved(near_centres(), 1, 0));
    int different = 0;
    for (size_t i = 0; i < here.size(); ++i)
        different += std::fabs(here[i][0] - next[i][0]) > 1e-3 ? 1 : 0;
    EXPECT_GT(different, 100);
}

TEST(HexTiling, HasNoSeams) {
    std::vector<std::array<double, 2>> line;
    for (int i = 0; i < 8000; ++i)
        line.push_back({-1 + i * 2.5e-4, 0.3 + i * 1.3e-4});
    const std::string soft = R"("exponent": 2, "contrast": 0.4)";
    for (const Scene& scene :
         {Scene{one("hex_tile_height_map", R"("amplitude": 1)"), "n.height", heights},
          Scene{one("hex_tile_height_map", R"("amplitude": 1, )" + soft), "n.height", heights},
          Scene{one("hex_tile_color"), "n.color", heights},
          Scene{one("hex_tile_normal_map"), "n.gradient", normals}}) {
        SCOPED_TRACE(scene.nodes);
        const auto all = values(scene, line);
        for (size_t i = 1; i < all.size(); ++i)
            ASSERT_LT(std::fabs(all[i][0] - all[i - 1][0]), 0.02) << i;
    }
}

TEST(HexTiling, KeepsWhatIsTheSameEverywhere) {
    const Image grey = painted(8, [](double, double) { return std::array{0.7, 0.5, 0.25}; });
    const std::string linear =
        R"("n": {"type": "hex_tile_color", "in": {"image":
            {"file": "textures/weave_normal.png", "encoding": "linear"}}})";
    std::vector<std::array<double, 2>> points = near_centres();
    for (int i = 0; i < 200; ++i)
        points.push_back({i * 0.37, i * -0.211});
    for (const auto& color : values({linear, "n.color", grey}, points)) {
        EXPECT_NEAR(color[0], 0.7, 1e-6);
        EXPECT_NEAR(color[2], 0.25, 1e-6);
    }
}

}  // namespace
}  // namespace wrinkle::test
