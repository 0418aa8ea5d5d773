// Tests of weaves: the order of their crossings, the relief against differences and samples, and
// the numbers of their threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "nodes/relief.h"

namespace wrinkle::test {
namespace {

const char* const weaves[] = {"plain", "twill", "twill_3_1", "satin_5", "satin_8"};

std::string of_weave(const std::string& weave) {
    return "\"weave\": \"" + weave + "\"";
}
// An output at points in threads.
std::vector<std::vector<double>> read_weave(const std::string& in, const char* output,
                                            std::vector<Point> points) {
    for (Point& p : points)
        p = {p[0] / 4, p[1] / 4};
    return values({one("weave", "\"scale\": 4, " + in), std::string("n.") + output}, points);
}

// over[row][column] at the middles of 24 by 24 crossings, some of negative numbers.
constexpr int side = 24;
std::vector<std::vector<bool>> crossings_of(const std::string& weave) {
    std::vector<Point> points;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            points.push_back({column - 7.5, row - 3.5});
    const auto over = read_weave(of_weave(weave), "over", points);
    std::vector<std::vector<bool>> rows(side);
    for (size_t i = 0; i < over.size(); ++i) {
        EXPECT_TRUE(over[i][0] == 0 || over[i][0] == 1);
        rows[i / side].push_back(over[i][0] == 1);
    }
    return rows;
}
// The lengths of the runs of a row that begin and end in it; positive where the warp is on top.
std::set<int> runs_of(const std::vector<bool>& row) {
    std::set<int> runs;
    int from = -1;
    for (int k = 1; k < side; ++k)
        if (row[static_cast<size_t>(k)] != row[static_cast<size_t>(k) - 1]) {
            if (from >= 0) runs.insert(row[static_cast<size_t>(k) - 1] ? k - from : from - k);
            from = k;
        }
    return runs;
}

TEST(Weave, HasTheRunsOfItsName) {
    const std::pair<const char*, std::set<int>> runs[] = {{"plain", {1, -1}},
                                                          {"twill", {2, -2}},
                                                          {"twill_3_1", {3, -1}},
                                                          {"satin_5", {4, -1}},
                                                          {"satin_8", {7, -1}}};
    for (const auto& [weave, expected] : runs) {
        const auto rows = crossings_of(weave);
        for (size_t k = 0; k < side; ++k) {
            EXPECT_EQ(runs_of(rows[k]), expected) << weave;
            std::vector<bool> column;
            for (const auto& row : rows)
                column.push_back(row[k]);
            EXPECT_EQ(runs_of(column), expected) << weave;
        }
    }
}

// A twill has diagonals; the crossings that hold a satin do not even touch at corners.
TEST(Weave, HasDiagonalsIfItIsATwill) {
    for (const char* weave : {"twill", "twill_3_1"}) {
        const auto rows = crossings_of(weave);
        for (size_t row = 1; row < side; ++row)
            for (size_t column = 1; column < side; ++column)
                EXPECT_EQ(rows[row][column], rows[row - 1][column - 1]) << weave;
    }
    for (const char* weave : {"satin_5", "satin_8"}) {
        const auto rows = crossings_of(weave);
        for (size_t row = 1; row < side; ++row)
            for (size_t column = 1; column + 1 < side; ++column)
                EXPECT_TRUE(rows[row][column] ||
                            (rows[row - 1][column - 1] && rows[row - 1][column + 1]))
                    << weave;
    }
}

TEST(Weave, HasTheSlopesOfItsDifferences) {
    constexpr double step = 1e-3;
    for (const char* weave : weaves) {
        const auto points = random_cells(300, 20, 3);
        const Reading got = read("weave", of_weave(weave), points);
        size_t smooth = 0;
        for (size_t axis = 0; axis < 2; ++axis) {
            auto after = points, before = points;
            for (size_t i = 0; i < points.size(); ++i) {
                after[i][axis] += step;
                before[i][axis] -= step;
            }
            const auto high = value_of("weave", of_weave(weave), after);
            const auto low = value_of("weave", of_weave(weave), before);
            for (size_t i = 0; i < points.size(); ++i) {
                const double up = (high[i] - got.value[i]) / step;
                const double down = (got.value[i] - low[i]) / step;
                if (std::fabs(up - down) > 0.02) continue;  // a kink between them
                ++smooth;
                EXPECT_NEAR(got.slope[i][axis], (up + down) / 2, 2e-3) << weave;
            }
        }
        EXPECT_GT(smooth, 500U) << weave;
    }
}

// Far away, height and share of the warp are the means of samples.
TEST(Weave, FadesToItsMeans) {
    const auto points = random_cells(40000, 40, 5);
    for (const char* weave : weaves)
        for (const char* width : {"0.5", "0.9"}) {
            const std::string in = of_weave(weave) + ", \"width\": " + width;
            double height = 0, warp = 0;
            for (const double v : value_of("weave", in, points))
                height += v / 40000;
            for (const auto& v : read_weave(in, "over", points))
                warp += v[0] / 40000;
            const std::string far = one("weave", "\"scale\": 4000, " + in);
            EXPECT_NEAR(value({far, "n.value"})[0], height, 0.01) << weave << width;
            EXPECT_NEAR(value({far, "n.over"})[0], warp, 0.01) << weave << width;
            EXPECT_EQ(value({far, "n.detail"})[0], 0);
        }
}

// Where a pixel covers a thread the diagonals of a twill remain: `over` is near the mean over the
// pixel of `over` close up.
TEST(Weave, HasTheDiagonalsOfTwillsFarAway) {
    constexpr int n = 16;
    constexpr double box = 1;
    const auto places = random_cells(200, 20, 9);
    const std::string scale = std::to_string(box / pixel);
    for (const char* weave : {"twill", "twill_3_1"}) {
        for (const char* width : {"0.7", "1"}) {
            const std::string in = of_weave(weave) + ", \"width\": " + width;
            std::vector<Point> at = places, all;
            for (Point& p : at)
                p = {p[0] * pixel / box, p[1] * pixel / box};
            for (const Point& p : places)
                for (int k = 0; k < n * n; ++k)
                    all.push_back({p[0] + ((k % n + 0.5) / n - 0.5) * box,
                                   p[1] + ((k / n + 0.5) / n - 0.5) * box});
            const auto fine = read_weave(in, "over", all);
            const auto far =
                values({one("weave", "\"scale\": " + scale + ", " + in), "n.over"}, at);
            std::vector<double> means(places.size(), 0);
            double mean = 0, error = 0, deviation = 0;
            for (size_t i = 0; i < all.size(); ++i)
                means[i / (n * n)] += fine[i][0] / (n * n);
            for (const double m : means)
                mean += m / static_cast<double>(means.size());
            for (size_t i = 0; i < means.size(); ++i) {
                error += std::pow(far[i][0] - means[i], 2);
                deviation += std::pow(means[i] - mean, 2);
            }
            EXPECT_LT(std::sqrt(error), 0.6 * std::sqrt(deviation)) << weave << width;
        }
    }
}

// The edge of `over` has the width of a pixel.
TEST(Weave, CoversAPixelByBothThreads) {
    size_t between = 0;
    for (const auto& p : random_cells(400, 8, 6)) {
        const double over = value({one("weave", R"("scale": 150)"), "n.over"}, p[0], p[1])[0];
        between += over > 0.02 && over < 0.98;
    }
    EXPECT_GT(between, 40U);
}

TEST(Weave, HasNumbersOfItsThreads) {
    const auto points = random_cells(400, 20, 8);
    for (const char* weave : {"twill", "satin_5"}) {
        const auto get = [&](const char* output) {
            return read_weave(of_weave(weave), output, points);
        };
        const auto over = get("over"), thread = get("thread"), cell = get("cell"),
                   direction = get("direction"), tangent = get("tangent"), edge = get("edge"),
                   along = get("along"), center = get("center"), local = get("local"),
                   random = get("random");
        std::map<double, std::vector<double>> randoms;
        for (size_t i = 0; i < points.size(); ++i) {
            if (over[i][0] > 0 && over[i][0] < 1) continue;
            const size_t across = over[i][0] == 1 ? 0 : 1;
            const double number = std::floor(points[i][across]);
            const auto fract = [&](size_t c) { return points[i][c] - std::floor(points[i][c]); };
            EXPECT_EQ(thread[i][0], 2 * number + static_cast<double>(across));
            EXPECT_EQ(cell[i], (std::vector<double>{number, static_cast<double>(across)}));
            EXPECT_EQ(direction[i][across], 0);
            EXPECT_EQ(direction[i][1 - across], 1);
            EXPECT_NEAR(tangent[i][across], 1, 1e-6);
            EXPECT_NEAR(edge[i][0], 0.45 - std::fabs(fract(across) - 0.5), 1e-5);
            EXPECT_NEAR(along[i][0], fract(1 - across), 1e-5);
            EXPECT_NEAR(center[i][0] * 4, std::floor(points[i][0]) + 0.5, 1e-5);
            EXPECT_NEAR(local[i][1], fract(1) - 0.5, 1e-5);
            const auto [found, fresh] = randoms.try_emplace(thread[i][0], random[i]);
            EXPECT_EQ(found->second, random[i]);
        }
        std::set<std::vector<double>> different;
        for (const auto& [id, each] : randoms)
            different.insert(each);
        EXPECT_EQ(different.size(), randoms.size());
        EXPECT_GT(randoms.size(), 30U);
    }
}

}  // namespace
}  // namespace wrinkle::test
