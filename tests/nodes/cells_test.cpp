// Tests of nodes of cells: bricks fill the plane without overlap in every bond, and Voronoi cells
// are those of a search over 9 x 9 squares.
#include <gtest/gtest.h>

#include <algorithm>

#include "nodes/relief.h"

namespace wrinkle::test {
namespace {

// Outputs of a node of cells at points in cells; the uv is the point by `cells`.
struct Cells {
    std::vector<std::vector<double>> edge, cell, random, center, local, size;
};
constexpr double cells_per_uv = 4;

Cells read_cells(const std::string& type, const std::string& in, std::vector<Point> points) {
    for (Point& p : points)
        p = {p[0] / cells_per_uv, p[1] / cells_per_uv};
    const std::string node = one(type, "\"scale\": 4" + (in.empty() ? "" : ", " + in));
    const auto get = [&](const char* output) {
        return values({node, std::string("n.") + output}, points);
    };
    return {get("edge"), get("cell"), get("random"), get("center"), get("local"), get("size")};
}

const std::pair<const char*, std::vector<Point>> bonds[] = {
    {R"("bond": "running", "aspect": 2.5, "offset": 0.3)", {{2.5, 1}}},
    {R"("bond": "english", "aspect": 2.5)", {{2.5, 1}, {1.25, 1}}},
    {R"("bond": "flemish", "aspect": 2.5)", {{2.5, 1}, {1.25, 1}}},
    {R"("bond": "planks", "aspect": 4, "variation": 0.9)", {}},
    {R"("bond": "herringbone", "aspect": 2)", {{2, 1}, {1, 2}}},
    {R"("bond": "herringbone", "aspect": 3)", {{3, 1}, {1, 3}}},
    {R"("bond": "basket_weave", "aspect": 3)", {{3, 1}, {1, 3}}},
    {R"("bond": "spanish", "aspect": 1)", {{1, 1}}},
    {R"("bond": "spanish", "aspect": 2)", {{2, 1}, {1, 2}, {1, 1}}},
    {R"("bond": "spanish", "aspect": 3)", {{3, 1}, {1, 3}, {2, 2}}},
    {R"("bond": "running", "aspect": 2, "every": 3)", {{2, 1}}},
};

// Every point of the box of a brick is of that brick, so boxes do not overlap. Every point is in
// the box of its brick, so they leave no gap.
TEST(Bricks, FillThePlane) {
    const auto points = random_cells(200, 40, 5);
    for (const auto& [in, sizes] : bonds) {
        const Cells got = read_cells("bricks", std::string(in) + ", \"mortar\": 0", points);
        std::vector<Point> inside;
        for (size_t i = 0; i < points.size(); ++i) {
            const double w = got.size[i][0] * cells_per_uv, h = got.size[i][1] * cells_per_uv;
            EXPECT_TRUE(sizes.empty() || std::any_of(sizes.begin(), sizes.end(),
                                                     [&](const Point& size) {
                                                         return std::hypot(size[0] - w,
                                                                           size[1] - h) < 1e-5;
                                                     }))
                << in << w << " " << h;
            for (size_t c = 0; c < 2; ++c) {
                EXPECT_LE(std::fabs(got.local[i][c]), 0.5 + 1e-6) << in;
                EXPECT_NEAR(got.center[i][c] + got.local[i][c] * got.size[i][c],
                            points[i][c] / cells_per_uv, 1e-6);
            }
            const double x = (0.5 - std::fabs(got.local[i][0])) * w;
            const double y = (0.5 - std::fabs(got.local[i][1])) * h;
            EXPECT_NEAR(got.edge[i][0], std::min(x, y), 1e-5) << in;
            for (const Point& at : random_cells(5, 0.998, static_cast<unsigned>(i)))
                inside.push_back({got.center[i][0] * cells_per_uv + at[0] * w,
                                  got.center[i][1] * cells_per_uv + at[1] * h});
        }
        const Cells same = read_cells("bricks", std::string(in) + ", \"mortar\": 0", inside);
        for (size_t i = 0; i < inside.size(); ++i) {
            EXPECT_EQ(same.cell[i], got.cell[i / 5]) << in;
            EXPECT_EQ(same.random[i], got.random[i / 5]) << in;
        }
    }
}

// Far away a wall has its mean; of planks of one length, since their lengths are random.
TEST(Bricks, FadeToTheMeanOfTheBond) {
    const auto points = random_cells(20000, 400, 7);
    for (const auto& [in, sizes] : bonds) {
        const std::string all = std::string(in) + R"(, "mortar": 0.1, "bevel": 0.15)" +
                                (sizes.empty() ? R"(, "offset": 0.1)" : "");
        double near = 0;
        for (const double v : value_of("bricks", all, points, 1e-3))
            near += v / 20000;
        EXPECT_NEAR(value_of("bricks", all, {{0.3, 0.4}}, 20)[0], near, 0.01) << in;
    }
}

// Bricks of length 2 are moved by a half in rows 0, 3 and 6 only.
TEST(Bricks, MoveEveryNthRow) {
    for (const double row : {-3.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 6.0}) {
        const Cells got = read_cells("bricks", R"("every": 3, "aspect": 2)",
                                     {{0.2, row + 0.5}, {1.2, row + 0.5}});
        const bool moved = std::fmod(row, 3) == 0;
        EXPECT_EQ(got.cell[0] == got.cell[1], !moved) << row;
        EXPECT_NEAR(got.local[1][0], moved ? -0.4 : 0.1, 1e-6) << row;
    }
}

// Points of one centre have one cell and random number, others have others.
void expect_ids(const std::string& type, const std::string& in) {
    const Cells got = read_cells(type, in, random_cells(300, 12, 6));
    for (size_t i = 1; i < got.cell.size(); ++i) {
        const bool near = std::hypot(got.center[i][0] - got.center[0][0],
                                     got.center[i][1] - got.center[0][1]) < 1e-6;
        EXPECT_EQ(got.cell[i] == got.cell[0], near) << type << " " << in;
        EXPECT_EQ(got.random[i] == got.random[0], near) << type << " " << in;
        for (const double each : got.cell[i])
            EXPECT_EQ(each, std::round(each));
    }
}

TEST(Cells, HaveOneNumberEach) {
    for (const auto& [in, sizes] : bonds)
        expect_ids("bricks", in);
    expect_ids("hexagons", "");
    expect_ids("checker", "");
    expect_ids("domes", R"("stagger": 0.3)");
    expect_ids("voronoi", "");
}

// The edge of a hexagon is between its centre and the nearest of the six around it.
TEST(Hexagons, HaveTheDistanceToTheirEdge) {
    const auto points = random_cells(500, 20, 8);
    const Cells got = read_cells("hexagons", "", points);
    for (size_t i = 0; i < points.size(); ++i) {
        double edge = 9;
        for (int k = 0; k < 6; ++k) {
            const double angle = k * std::acos(-1) / 3;
            const double x = points[i][0] - got.center[i][0] * cells_per_uv;
            const double y = points[i][1] - got.center[i][1] * cells_per_uv;
            edge = std::min(edge, 0.5 - (x * std::cos(angle) + y * std::sin(angle)));
        }
        EXPECT_NEAR(got.edge[i][0], edge, 1e-5);
        EXPECT_GE(edge, -1e-5);
    }
}

// A corner of radius 0.2 in a brick of 2 by 1 with mortar of 0.1: the arc is around its centre.
TEST(Bricks, HaveRoundCorners) {
    const auto edge = [](double x, double y) {
        return read_cells("bricks", R"("offset": 0, "mortar": 0.1, "radius": 0.2)", {{x, y}})
            .edge[0][0];
    };
    EXPECT_NEAR(edge(0.25, 0.25), 0.2, 1e-6);
    EXPECT_NEAR(edge(0.25 - 0.12, 0.25 - 0.16), 0, 1e-6);
    EXPECT_NEAR(edge(1, 0.05), 0, 1e-6);
    EXPECT_NEAR(edge(1, 0.25), 0.2, 1e-6);
}

// The feature points of 9 x 9 squares around a point, relative to it, nearest first.
struct Feature {
    double x, y, distance;
    std::vector<double> square;
};
std::vector<Feature> features_around(Point p, int seed) {
    std::vector<Feature> features;
    const int cx = static_cast<int>(std::floor(p[0])), cy = static_cast<int>(std::floor(p[1]));
    for (int row = cy - 4; row <= cy + 4; ++row)
        for (int column = cx - 4; column <= cx + 4; ++column) {
            const uint32_t bits = pcg(column, row, seed);
            const double x = column + unit_number(bits) - p[0];
            const double y = row + unit_number(pcg(bits)) - p[1];
            features.push_back({x, y, std::hypot(x, y), {double(column), double(row)}});
        }
    std::sort(features.begin(), features.end(),
              [](const Feature& a, const Feature& b) { return a.distance < b.distance; });
    return features;
}
double nearest_edge(const std::vector<Feature>& features) {
    const Feature& own = features[0];
    double edge = 9;
    for (size_t k = 1; k < features.size(); ++k) {
        const double dx = features[k].x - own.x, dy = features[k].y - own.y;
        const double middle = (features[k].x + own.x) / 2 * dx + (features[k].y + own.y) / 2 * dy;
        edge = std::min(edge, middle / std::hypot(dx, dy));
    }
    return edge;
}

TEST(Voronoi, IsThatOfALargeSearch) {
    const auto points = random_cells(4000, 60, 9);
    const std::string in = R"("seed": 3, "jitter": 1)";
    const Cells got = read_cells("voronoi", in, points);
    std::vector<Point> uvs = points;
    for (Point& p : uvs)
        p = {p[0] / cells_per_uv, p[1] / cells_per_uv};
    const std::string node = one("voronoi", "\"scale\": 4, " + in);
    const auto f1 = values({node, "n.f1"}, uvs), f2 = values({node, "n.f2"}, uvs);
    size_t missed = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        const auto features = features_around(points[i], 3);
        const Feature& own = features[0];
        EXPECT_NEAR(f1[i][0], own.distance, 1e-5);
        EXPECT_NEAR(got.edge[i][0], nearest_edge(features), 1e-5);
        EXPECT_EQ(got.cell[i], own.square);
        EXPECT_NEAR(got.center[i][0] * cells_per_uv, points[i][0] + own.x, 1e-5);
        EXPECT_NEAR(got.local[i][1], -own.y, 1e-5);
        missed += std::fabs(f2[i][0] - features[1].distance) > 1e-5;
    }
    EXPECT_LE(missed, 4U);  // second points beyond 3 x 3 squares
}

// A step shorter than the edge along its slope stays in the cell, a longer one leaves it: cells
// change where the edge is 0, and only there.
TEST(Cells, ChangeWhereTheEdgeIsZero) {
    constexpr double near = 1e-5;
    const std::pair<const char*, const char*> cells[] = {
        {"voronoi", R"("jitter": 1)"},
        {"hexagons", R"("mortar": 0)"},
        {"bricks", R"("mortar": 0, "bond": "english")"},
        {"bricks", R"("mortar": 0, "bond": "herringbone")"}};
    const auto points = random_cells(2000, 40, 11);
    for (const auto& [type, in] : cells) {
        const Cells here = read_cells(type, in, points);
        const std::string slope =
            R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.edge"}}})";
        std::vector<Point> uvs = points, inside = points, outside = points;
        for (Point& p : uvs)
            p = {p[0] / cells_per_uv, p[1] / cells_per_uv};
        const auto slopes =
            values({one(type, std::string(R"("scale": 4, )") + in) + slope, "g.gradient"}, uvs);
        for (size_t i = 0; i < points.size(); ++i)
            for (size_t axis = 0; axis < 2; ++axis) {
                const double way = slopes[i][axis] / cells_per_uv, edge = here.edge[i][0];
                inside[i][axis] -= way * (edge - near);
                outside[i][axis] -= way * (edge + near);
            }
        const Cells before = read_cells(type, in, inside), after = read_cells(type, in, outside);
        for (size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR(before.edge[i][0], near, 1e-6) << type << in;
            EXPECT_EQ(before.cell[i], here.cell[i]) << type << in;
            EXPECT_NE(after.cell[i], here.cell[i]) << type << in;
        }
    }
}

TEST(Voronoi, HasSlopesOfOne) {
    for (const char* output : {"edge", "f1", "f2"}) {
        const std::string nodes =
            one("voronoi") +
            R"(, "g": {"type": "gradient_from_height", "in": {"height": {"from": "n.)" + output +
            "\"}}}";
        for (const auto& g : values({nodes, "g.gradient"}, random_cells(200, 6, 4)))
            EXPECT_NEAR(std::hypot(g[0], g[1]), 6, 1e-4) << output;
    }
}

}  // namespace
}  // namespace wrinkle::test
