// Tests of filtering of procedural heights: close up they are exact, far away they are flat, and in
// between the slope approximates that of the mean over a pixel.
#include <gtest/gtest.h>

#include <algorithm>

#include "nodes/relief.h"

namespace wrinkle::test {
namespace {

double rms(const std::vector<Point>& slopes) {
    double sum = 0;
    for (const Point& slope : slopes)
        sum += slope[0] * slope[0] + slope[1] * slope[1];
    return std::sqrt(sum / static_cast<double>(slopes.size()));
}

TEST(Footprint, ThereAreProceduralNodesToTest) {
    EXPECT_GE(procedural_nodes().size(), 16U);
}

TEST(Footprint, ChangesNothingCloseUp) {
    const auto places = random_cells(300, 20, 21);
    for (const std::string& type : procedural_nodes()) {
        const Reading near = read(type, "", places, 1e-3), nearer = read(type, "", places, 1e-5);
        for (size_t i = 0; i < places.size(); ++i)
            EXPECT_NEAR(near.value[i], nearer.value[i], 1e-5) << type;
        EXPECT_GT(rms(near.slope), 0.05) << type << " is flat";
    }
}

TEST(Footprint, FlattensWhatIsFarAway) {
    const auto places = random_cells(300, 5000, 22);
    for (const std::string& type : procedural_nodes()) {
        const double near = rms(read(type, "", places, 1e-3).slope);
        const Reading far = read(type, "", places, 9.7);
        // Box filters leave a residue if a box does not contain a whole number of periods.
        const bool box = type == "checker" || type == "wave";
        EXPECT_LE(rms(far.slope), box ? 0.04 * near : 0) << type;
    }
}

// The value fades to the pattern's mean close up, so that a mask made of it keeps its strength. The
// means in the nodes are measured over space or ignore overlaps; the mean of this plane differs by
// up to a fortieth.
TEST(Footprint, FadesToTheMean) {
    const auto places = random_cells(20000, 400, 23);
    for (const std::string& type : procedural_nodes()) {
        double near = 0, far = 0;
        for (const double v : value_of(type, "", places, 1e-3))
            near += v / 20000;
        for (const double v : value_of(type, "", {places.begin(), places.begin() + 50}, 20))
            far += v / 50;
        EXPECT_NEAR(near, far, 0.025) << type;
    }
}

double apart(std::vector<Point> a, const std::vector<Point>& b) {
    for (size_t i = 0; i < a.size(); ++i)
        a[i] = {a[i][0] - b[i][0], a[i][1] - b[i][1]};
    return rms(a);
}

// The mean slope over a box of one pixel, of the pattern as it is close up.
std::vector<Point> mean_slopes(const std::string& type, const std::string& in,
                               const std::vector<Point>& places, double box) {
    constexpr int n = 12;
    std::vector<Point> all;
    for (const Point& p : places)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                all.push_back(
                    {p[0] + ((x + 0.5) / n - 0.5) * box, p[1] + ((y + 0.5) / n - 0.5) * box});
    const Reading fine = read(type, in, all);
    std::vector<Point> means(places.size(), Point{0, 0});
    for (size_t i = 0; i < all.size(); ++i)
        for (size_t k = 0; k < 2; ++k)
            means[i / (n * n)][k] += fine.slope[i][k] / (n * n);
    return means;
}

// A fade approximates the mean over a pixel: it scales a complete cell by one factor, while the
// mean loses the fine parts sooner and the coarsest parts last. The difference from the mean is
// therefore less than half of the slope close up if a cell is at least two pixels. At one pixel the
// difference is everything that the mean retains: most for value noise, the coarsest relative to
// its cells. Plain sampling is off by about the full slope there.
TEST(Footprint, StandsForTheMeanOverAPixel) {
    const auto places = random_cells(150, 40, 24);
    const std::pair<const char*, const char*> cases[] = {{"gradient_noise", R"("octaves": 1)"},
                                                         {"simplex_noise", ""},
                                                         {"value_noise", ""},
                                                         {"worley_noise", ""},
                                                         {"fbm", ""},
                                                         {"turbulence", ""},
                                                         {"ridged", ""},
                                                         {"waves", ""},
                                                         {"pyramids", ""},
                                                         {"hexagons", R"("bevel": 0.3)"},
                                                         {"brick", R"("bevel": 0.3)"},
                                                         {"domes", R"("roundness": 0.5)"},
                                                         {"weave", ""}};
    for (const auto& [type, in] : cases) {
        const auto unfiltered = read(type, in, places).slope;
        const double close = rms(unfiltered);
        for (const auto& [box, allowed] :
             {std::pair{0.1, 0.45}, std::pair{0.5, 0.45}, std::pair{1.0, 0.65}}) {
            const auto means = mean_slopes(type, in, places, box);
            const double with = apart(read(type, in, places, box).slope, means),
                         without = apart(unfiltered, means);
            EXPECT_LE(with, allowed * close) << type << " over " << box;
            EXPECT_LE(with, without + 0.2 * close) << type << " over " << box;
        }
    }
}

TEST(Procedural, IsFiniteInCornersAndFarOut) {
    std::vector<Point> places{{0, 0},     {1, 1},    {-1, 0.5},          {0.5, 0.5}, {-0.5, -0.5},
                              {1e5, 1e5}, {-1e5, 0}, {1e5 + 0.25, -1e5}, {1e7, 3e7}, {-0.0, 1e-30}};
    for (const std::string& type : procedural_nodes()) {
        const Reading got = read(type, "", places);
        for (size_t i = 0; i < places.size(); ++i) {
            EXPECT_TRUE(std::isfinite(got.value[i])) << type << " at " << i;
            EXPECT_LE(std::fabs(got.value[i]), 2) << type << " at " << i;
            EXPECT_TRUE(std::isfinite(got.slope[i][0] + got.slope[i][1])) << type << " at " << i;
        }
    }
}

// Close to the border of a unit cell, and along a line through cells of other borders: no value
// jumps. Scratches of several layers are the steepest.
TEST(Procedural, HasNoSeamsBetweenCells) {
    constexpr double near = 1e-7, step = 2e-4;
    std::vector<Point> border, line;
    for (const Point& p : random_cells(200, 20, 31))
        for (const double side : {-near, near}) {
            border.push_back({std::round(p[0]) + side, p[1]});
            border.push_back({p[0], std::round(p[1]) + side});
        }
    for (int i = 0; i < 20000; ++i)
        line.push_back({-2 + i * step, 3.3 - 0.37 * i * step});
    for (const std::string& type : procedural_nodes()) {
        const auto at = value_of(type, "", border), along = value_of(type, "", line);
        for (size_t i = 0; i < border.size(); i += 4)
            for (const size_t axis : {0, 1})
                EXPECT_NEAR(at[i + axis], at[i + 2 + axis], 1e-5) << type << " at " << border[i][0];
        for (size_t i = 1; i < line.size(); ++i)
            ASSERT_NEAR(along[i - 1], along[i], 60 * step) << type << " at " << line[i][0];
    }
}

}  // namespace
}  // namespace wrinkle::test
