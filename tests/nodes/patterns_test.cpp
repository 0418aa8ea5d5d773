// Tests of patterns against the documented shapes, built from points, planes and spheres.
#include <gtest/gtest.h>

#include <algorithm>

#include "nodes/relief.h"

namespace wrinkle::test {
namespace {

using Point3 = std::array<double, 3>;

// Height at which the vertical line through p intersects the triangle; -1 if it misses.
double height_over(const std::array<Point3, 3>& t, Point p) {
    const auto side = [&](const Point3& a, const Point3& b) {
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    };
    const double w0 = side(t[1], t[2]), w1 = side(t[2], t[0]), w2 = side(t[0], t[1]);
    if (std::min({w0, w1, w2}) < 0) return -1;
    return (w0 * t[0][2] + w1 * t[1][2] + w2 * t[2][2]) / (w0 + w1 + w2);
}

TEST(Pyramids, AreFourTriangles) {
    const auto places = random_cells(4000, 12, 2);
    for (const double base : {0.5, 0.9}) {
        const Reading got = read("pyramids", "\"base\": " + std::to_string(base), places);
        size_t on_a_side = 0;
        for (size_t i = 0; i < places.size(); ++i) {
            const double cx = std::floor(places[i][0]) + 0.5, cy = std::floor(places[i][1]) + 0.5;
            const double r = base / 2;
            const Point3 tip{cx, cy, 1}, corners[] = {{cx - r, cy - r, 0},
                                                      {cx + r, cy - r, 0},
                                                      {cx + r, cy + r, 0},
                                                      {cx - r, cy + r, 0}};
            double truth = 0;
            for (size_t k = 0; k < 4; ++k)
                truth = std::max(truth,
                                 height_over({corners[k], corners[(k + 1) % 4], tip}, places[i]));
            EXPECT_NEAR(got.value[i], truth, 1e-5);
            // S4: the height over a quarter of a cell is the slope of a side, along one axis.
            if (truth < 0.01) continue;
            ++on_a_side;
            const double steep = std::hypot(got.slope[i][0], got.slope[i][1]);
            EXPECT_NEAR(steep, 1 / r, 1e-3 / r);
            EXPECT_NEAR(got.slope[i][0] * got.slope[i][1], 0, 1e-3);
        }
        EXPECT_NEAR(static_cast<double>(on_a_side) / 4000, base * base, 0.04);
    }
}

// The profile of a groove: flat bottom, slopes, flat tops.
double profile(double to_middle, double mortar, double bevel) {
    return std::clamp((to_middle - mortar / 2) / bevel, 0.0, 1.0);
}

double to_segment(Point p, Point a, Point b) {
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double t =
        std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

TEST(Brick, IsAsFarFromTheOutlinesOfBricks) {
    const auto places = random_cells(3000, 12, 4);
    const auto got =
        value_of("brick", R"("aspect": 2.2, "offset": 0.3, "mortar": 0.1, "bevel": 0.15)", places);
    size_t in_grooves = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        double nearest = 9;
        for (int row = -8; row <= 8; ++row)
            for (int k = -12; k <= 12; ++k) {
                const double x = (k + 0.3 * row) * 2.2, right = x + 2.2;
                const double low = row, high = row + 1;
                const Point a{x, low}, b{right, low}, c{right, high}, d{x, high};
                // Inside the outline of the brick itself; neighbours may end inside it.
                if (places[i][0] < x || places[i][0] > right || places[i][1] < low ||
                    places[i][1] > high)
                    continue;
                nearest = std::min({to_segment(places[i], a, b), to_segment(places[i], b, c),
                                    to_segment(places[i], c, d), to_segment(places[i], d, a)});
            }
        EXPECT_NEAR(got[i], profile(nearest, 0.1, 0.15), 1e-5);
        in_grooves += nearest < 0.1 ? 1 : 0;
    }
    EXPECT_GT(in_grooves, 300U);
}

// In a long wall of one brick per row, grooves narrower and wider than a pixel.
TEST(Brick, HasTheMeanOfAGrooveOverAPixel) {
    std::vector<Point> places;
    for (int i = 0; i < 60; ++i)
        places.push_back({47.3, 3 + i / 60.0});
    for (const auto& [mortar, box] : {std::pair{0.04, 0.15}, std::pair{0.2, 0.1}}) {
        const std::string in = R"("aspect": 100, "offset": 0, "bevel": 0.01, "mortar": )";
        const auto got = value_of("brick", in + std::to_string(mortar), places, box);
        for (size_t i = 0; i < places.size(); ++i) {
            double mean = 0;
            for (int k = 0; k < 1000; ++k) {
                const double y = places[i][1] + ((k + 0.5) / 1000 - 0.5) * box;
                mean += profile(std::fabs(y - std::round(y)), mortar, 0.01) / 1000;
            }
            EXPECT_NEAR(got[i], mean, 0.03) << "at " << places[i][1];
        }
    }
}

// A tile contains the points that are nearer to its centre than to the six around it.
TEST(Hexagons, AreTheCellsOfTheirCentres) {
    const auto places = random_cells(3000, 12, 6);
    const auto got = value_of("hexagons", R"("mortar": 0.08, "bevel": 0.12)", places);
    const double high = std::sqrt(3.0) / 2;
    std::vector<Point> centres;
    for (int j = -10; j <= 10; ++j)
        for (int i = -16; i <= 16; ++i)
            centres.push_back({i + (j % 2 ? 0.5 : 0), j * high});
    size_t in_grooves = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        const auto square = [&](const Point& c) {
            return std::pow(places[i][0] - c[0], 2) + std::pow(places[i][1] - c[1], 2);
        };
        const Point own = *std::min_element(
            centres.begin(), centres.end(),
            [&](const Point& a, const Point& b) { return square(a) < square(b); });
        double nearest = 9;
        for (const Point& c : centres)
            if (c != own)
                nearest = std::min(nearest, (square(c) - square(own)) / 2 /
                                                std::hypot(c[0] - own[0], c[1] - own[1]));
        EXPECT_NEAR(got[i], profile(nearest, 0.08, 0.12), 1e-5);
        in_grooves += nearest < 0.1 ? 1 : 0;
    }
    EXPECT_GT(in_grooves, 600U);
}

// The mean of hard squares over a box, by counting.
// A product of a row and a column of sides, so that each axis has its own 4096 samples.
TEST(Checker, IsTheMeanOverABox) {
    const auto places = random_cells(60, 8, 9);
    for (const double box : {0.3, 0.9, 1.6, 2.7}) {
        const auto got = value_of("checker", R"("bevel": 0.02)", places, box);
        const auto side = [&](double x) {
            double sum = 0;
            for (int k = 0; k < 4096; ++k) {
                const double at = std::floor(x + ((k + 0.5) / 4096 - 0.5) * box);
                sum += (std::fmod(at, 2) == 0 ? 1 : -1) / 4096.0;
            }
            return sum;
        };
        for (size_t i = 0; i < places.size(); ++i)
            EXPECT_NEAR(got[i], 0.5 + 0.5 * side(places[i][0]) * side(places[i][1]), 1e-3) << box;
    }
}

TEST(Domes, AreCapsOfASphere) {
    const auto places = random_cells(3000, 10, 11);
    const double sine = 0.8, radius = 0.45, sphere = radius / sine;
    const double plane = std::sqrt(sphere * sphere - radius * radius);
    const auto got = value_of("domes", R"("base": 0.9, "roundness": 0.8, "stagger": 0.25)", places);
    for (size_t i = 0; i < places.size(); ++i) {
        double truth = 0;
        for (int row = -7; row <= 7; ++row)
            for (int k = -10; k <= 10; ++k) {
                const double dx = places[i][0] - (k + 0.5 + 0.25 * row),
                             dy = places[i][1] - (row + 0.5);
                const double square = sphere * sphere - dx * dx - dy * dy;
                if (square > plane * plane)
                    truth = std::max(truth, (std::sqrt(square) - plane) / (sphere - plane));
            }
        EXPECT_NEAR(got[i], truth, 1e-4);
    }
}

// Across the middle of a cell: the upper thread is a parabola, the other thread goes below it at
// 0.35; the next cell is the same with u and v exchanged; four threads meet at a hole.
TEST(Weave, GoesOverAndUnder) {
    const std::string in = R"("width": 0.8)";
    std::vector<Point> across, along, next;
    for (int i = 0; i < 100; ++i) {
        const double d = (i + 0.5) / 100 - 0.5;
        across.push_back({4.5 + d, -1.5});
        along.push_back({4.5, -1.5 + d});
        next.push_back({5.5, -1.5 + d});
    }
    const auto over = value_of("weave", in, across), beside = value_of("weave", in, next);
    const auto [low, high] = [&] {
        const auto all = value_of("weave", in, along);
        const auto ends = std::minmax_element(all.begin(), all.end());
        return std::pair{*ends.first, *ends.second};
    }();
    EXPECT_NEAR(high, 1, 1e-3);
    EXPECT_NEAR(low, 0.675, 0.02);  // halfway down, above the border of two cells
    for (size_t i = 0; i < across.size(); ++i) {
        const double d = across[i][0] - 4.5;
        // Below the upper thread, the other one rises again with the distance from the middle.
        const double under = 0.675 - 0.325 * std::cos(3.14159265358979 * d);
        EXPECT_NEAR(over[i], std::max(1 - d * d / 0.16, under), 1e-5);
        EXPECT_NEAR(beside[i], over[i], 1e-5);
    }
    for (const double hole : value_of("weave", in, {{3, 2}, {-1, 0}, {4.02, 7.97}}))
        EXPECT_EQ(hole, 0);
}

// A wave of frequency f has |slope|^2 + (2 pi f)^2 value^2 = (2 pi f)^2 everywhere.
TEST(Waves, OfOneKeepTheirEnergy) {
    const auto places = random_cells(500, 8, 12);
    const double full = 4 * 3.14159265358979 * 3.14159265358979;
    for (const char* shape : {"straight", "rings"}) {
        const Reading wave = read(
            "waves", std::string(R"("count": 1, "phase": 0.2, "shape": ")") + shape + '"', places);
        for (size_t i = 0; i < places.size(); ++i) {
            const double energy = std::pow(wave.slope[i][0], 2) + std::pow(wave.slope[i][1], 2) +
                                  full * std::pow(wave.value[i], 2);
            EXPECT_NEAR(energy, full, 0.01) << shape;
        }
    }
}

TEST(Waves, GoWhereTheyAreSent) {
    const auto at = [](const char* in, Point p) {
        return value_of("waves", std::string(in) + R"(, "count": 1, "spread": 0)", {p})[0];
    };
    // Constant across the direction; a period along it is 1; a phase shifts the wave.
    const char* in = R"("direction": 30)";
    const double x = std::cos(0.5235987756), y = std::sin(0.5235987756);
    const double here = at(in, {0.2, 0.4});
    EXPECT_NEAR(at(in, {0.2 - 3 * y, 0.4 + 3 * x}), here, 1e-4);
    EXPECT_NEAR(at(in, {0.2 + x, 0.4 + y}), here, 1e-4);
    EXPECT_NEAR(at(R"("direction": 30, "phase": 0.3)", {0.2 + 0.3 * x, 0.4 + 0.3 * y}), here, 1e-4);
    EXPECT_GT(std::fabs(at(in, {0.2 + 0.5 * x, 0.4 + 0.5 * y}) - here), 0.1);
}

TEST(Scratches, AreAsManyAsAsked) {
    const auto places = random_cells(20000, 60, 13);
    const auto share = [&](const char* in) {
        double sum = 0;
        for (const double depth : value_of("scratches", in, places)) {
            EXPECT_GE(depth, -1);
            EXPECT_LE(depth, 0);
            sum -= depth;
        }
        return sum / 20000;
    };
    EXPECT_EQ(share(R"("density": 0)"), 0);
    // Half of length times width times the fraction of cells, minus the overlap.
    EXPECT_NEAR(share(R"("density": 1, "layers": 1, "width": 0.05, "length": 1)"), 0.025, 0.003);
    EXPECT_NEAR(share(R"("density": 0.5, "layers": 1, "width": 0.05, "length": 1)"), 0.0125, 0.002);
    EXPECT_NEAR(share(R"("density": 0.5, "layers": 3, "width": 0.03, "length": 1)"), 0.0225, 0.003);
}

// If a stroke were clipped at the border of a cell, its depth would be discontinuous there.
TEST(Scratches, AreWholeAcrossCells) {
    std::vector<Point> line;
    for (int i = 0; i < 20000; ++i)
        line.push_back({-9 + i * 8e-4, 3 + i * 6e-4});
    const auto depth =
        value_of("scratches", R"("density": 1, "length": 1.5, "width": 0.2, "layers": 1)", line);
    for (size_t i = 1; i < line.size(); ++i)
        ASSERT_LE(std::fabs(depth[i] - depth[i - 1]), 1.6 * 1e-3 / 0.2) << i;
}

TEST(Scratches, LieAsTheyAreTurned) {
    const Reading got = read("scratches", R"("direction": 90, "spread": 0, "width": 0.01)",
                             random_cells(20000, 30, 14));
    double across = 0, along = 0;
    for (const Point& slope : got.slope)
        across += std::fabs(slope[0]), along += std::fabs(slope[1]);
    EXPECT_GT(across, 20 * along);
}

}  // namespace
}  // namespace wrinkle::test
