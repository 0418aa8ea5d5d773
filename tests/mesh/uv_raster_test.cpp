// Tests of texel ownership, against an integer ray cast through each centre.
#include "mesh/uv_raster.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <limits>
#include <random>
#include <set>

#include "mesh/shapes.h"

namespace wrinkle {
namespace {

// Corners in 1/16 texel of a layout of 64 x 64: exact in a float and in the raster.
struct Corner {
    int x, y;
};
constexpr int side = 64, parts = 16;
constexpr uint32_t none = Coverage::none;

Mesh mesh_of(const std::vector<Corner>& corners) {
    Mesh mesh;
    for (const Corner& c : corners) {
        mesh.indices.push_back(static_cast<uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(0);
        mesh.uvs[0].emplace_back(static_cast<float>(c.x) / (side * parts),
                                 static_cast<float>(c.y) / (side * parts));
    }
    return mesh;
}

Coverage cover(const Mesh& mesh, const TexelRect& rect, uint32_t samples = 1,
               glm::ivec2 corner = glm::ivec2(0)) {
    const UvRaster raster(mesh, {side, side, corner, samples});
    Coverage coverage;
    raster.cover(rect, raster.in_rows(rect.y, rect.height), coverage);
    return coverage;
}
Coverage cover(const Mesh& mesh, uint32_t samples = 1) {
    return cover(mesh, {0, 0, side, side}, samples);
}

enum class Side { inside, outside, on_edge };

// Counts the edges that a ray to the right crosses.
Side side_of(const Corner* t, int x, int y) {
    bool inside = false;
    for (int k = 0; k < 3; ++k) {
        const Corner a = t[k], b = t[(k + 1) % 3];
        const long turn =
            static_cast<long>(b.x - a.x) * (y - a.y) - static_cast<long>(b.y - a.y) * (x - a.x);
        if (turn == 0 && std::min(a.x, b.x) <= x && x <= std::max(a.x, b.x) &&
            std::min(a.y, b.y) <= y && y <= std::max(a.y, b.y))
            return Side::on_edge;
        if ((a.y > y) != (b.y > y) && (turn > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside ? Side::inside : Side::outside;
}

TEST(UvRaster, OwnsTheCentresInsideATriangle) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> any(-20 * parts, (side + 20) * parts);
    int inside = 0, on_edge = 0;
    for (int i = 0; i < 300; ++i) {
        std::vector<Corner> t(3);
        for (Corner& c : t) {
            c = {any(random), any(random)};
            if (i % 3 == 0) c = {c.x / 8 * 8, c.y / 8 * 8};  // often through centres
            if (i % 5 == 0) c = {c.x / 40 + 300, c.y};       // thin
        }
        const Coverage got = cover(mesh_of(t));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Side place = side_of(t.data(), x * parts + parts / 2, y * parts + parts / 2);
                const bool owned = got.owners[static_cast<size_t>(y * side + x)] == 0;
                if (place != Side::on_edge) {
                    ASSERT_EQ(owned, place == Side::inside) << i << ": " << x << ", " << y;
                }
                inside += place == Side::inside;
                on_edge += place == Side::on_edge;
            }
        EXPECT_EQ(got.overlapped, 0U);
    }
    EXPECT_GT(inside, 10000);
    EXPECT_GT(on_edge, 50);
}

// Triangles between displaced knots of a grid; every second triangle is mirrored.
std::vector<Corner> torn_grid(int knots, int step, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> move(-1, 1);
    std::vector<Corner> knot;
    for (int j = 0; j <= knots; ++j)
        for (int i = 0; i <= knots; ++i) {
            const bool inner = i > 0 && j > 0 && i < knots && j < knots;
            knot.push_back({i * step + (inner ? move(random) * step / 8 : 0),
                            j * step + (inner ? move(random) * step / 8 : 0)});
        }
    std::vector<Corner> corners;
    for (int j = 0; j < knots; ++j)
        for (int i = 0; i < knots; ++i) {
            const auto at = [&](int dx, int dy) {
                return knot[static_cast<size_t>((j + dy) * (knots + 1) + i + dx)];
            };
            corners.insert(corners.end(), {at(0, 0), at(1, 0), at(1, 1)});
            corners.insert(corners.end(), {at(0, 0), at(0, 1), at(1, 1)});
        }
    return corners;
}

TEST(UvRaster, NeighboursShareNoTexelAndLeaveNone) {
    for (const int knots : {8, 32, 64, 128}) {  // down to triangles of half a texel
        const auto corners = torn_grid(knots, side * parts / knots, 7);
        const Coverage all = cover(mesh_of(corners));
        EXPECT_EQ(all.overlapped, 0U) << knots;
        EXPECT_EQ(std::count(all.owners.begin(), all.owners.end(), none), 0) << knots;
        for (const uint32_t owner : {0U, 5U, static_cast<uint32_t>(corners.size() / 3 - 1)}) {
            const auto first = corners.begin() + 3 * owner;
            const Coverage alone = cover(mesh_of({first, first + 3}));
            for (size_t i = 0; i < alone.owners.size(); ++i)
                EXPECT_EQ(alone.owners[i] == 0, all.owners[i] == owner) << knots;
        }
    }
}

TEST(UvRaster, ALevelEdgesCentresBelongToTheTriangleAbove) {
    // Two squares; their common edge and the borders of both go through texel centres.
    const std::vector<Corner> both = {{8, 8},  {72, 8},  {72, 40}, {8, 8},  {72, 40}, {8, 40},
                                      {8, 40}, {72, 40}, {72, 72}, {8, 40}, {72, 72}, {8, 72}};
    const Coverage got = cover(mesh_of(both));
    EXPECT_EQ(got.overlapped, 0U);
    EXPECT_EQ(got.owned, 16U);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const uint32_t owner = got.owners[static_cast<size_t>(y * side + x)];
            const bool inside = x < 4 && y < 4;
            EXPECT_EQ(owner == none, !inside) << x << ", " << y;
            if (inside) {
                EXPECT_EQ(owner >= 2, y >= 2) << x << ", " << y;
            }
        }
}

TEST(UvRaster, ALineOwnsNothingHoweverItsCornersAreRounded) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(0.05F, 0.45F);
    for (int i = 0; i < 400; ++i) {
        Mesh line = mesh_of({{0, 0}, {0, 0}, {0, 0}});
        const glm::vec2 middle(any(random), any(random));
        line.uvs[0] = {glm::vec2(0), middle * 2.0F, middle};
        const Coverage got = cover(line);
        ASSERT_EQ(got.owned, 0U) << i;
        ASSERT_EQ(std::count(got.owners.begin(), got.owners.end(), none), side * side) << i;
    }
}

TEST(UvRaster, TheFirstTriangleOwnsWhatOthersCoverToo) {
    const std::vector<Corner> both = {{0, 0}, {512, 0}, {0, 512}, {512, 0}, {0, 0}, {0, 512}};
    const Coverage got = cover(mesh_of(both));
    const auto owned = static_cast<uint32_t>(std::count(got.owners.begin(), got.owners.end(), 0));
    EXPECT_GT(owned, 490U);
    EXPECT_EQ(got.owned, owned);
    EXPECT_EQ(std::count(got.owners.begin(), got.owners.end(), 1), 0);
    EXPECT_EQ(got.overlapped, owned);
    EXPECT_EQ(got.overlap_triangle, 1U);
    EXPECT_EQ(got.overlap_texel, 0U);
}

TEST(UvRaster, AnOverlapOfManyTrianglesCountsEachTexelOnce) {
    std::vector<Corner> corners;
    for (int i = 0; i < 5; ++i)  // all differ, so that none is dropped
        corners.insert(corners.end(), {{0, 0}, {512 + i, 0}, {0, 512 + i}});
    const Coverage one = cover(mesh_of({{0, 0}, {512, 0}, {0, 512}}));
    const Coverage got = cover(mesh_of(corners));
    EXPECT_GE(got.overlapped, one.owned);
    EXPECT_LE(got.overlapped, got.owned);
    EXPECT_EQ(got.overlap_triangle, 1U);
    EXPECT_EQ(got.overlap_texel, 0U);
}

// The count of pairs would overflow 32 bits; the time limits catch quadratic run time.
TEST(UvRaster, AMillionTrianglesOnOnePlaceAreOwnedByTheFirst) {
    for (const bool alike : {true, false}) {
        std::vector<Corner> corners;
        const int count = alike ? 1'000'000 : 100'000;
        for (int i = 0; i < count; ++i) {
            const int shift = alike ? 0 : i % 97;
            std::array<Corner, 3> t{{{1024 - shift, 0}, {0, 1024 - shift / 7}, {0, shift}}};
            std::rotate(t.begin(), t.begin() + i % 3, t.end());
            if (i % 2 == 1) std::swap(t[0], t[1]);  // mirrored
            corners.insert(corners.end(), t.begin(), t.end());
        }
        const Mesh mesh = mesh_of(corners);
        const auto start = std::chrono::steady_clock::now();
        const Coverage got = cover(mesh, 4);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15)) << alike;
        const Coverage two = cover(mesh_of({corners.begin(), corners.begin() + 6}), 4);
        EXPECT_LE(got.overlapped, got.owners.size());
        EXPECT_GE(got.overlapped, two.overlapped);
        EXPECT_EQ(got.overlap_triangle, two.overlap_triangle);
        if (!alike) continue;
        EXPECT_EQ(got.overlapped, two.overlapped);
        EXPECT_EQ(got.owners, two.owners);
        EXPECT_EQ(got.edges.size(), two.edges.size());
    }
}

// Sum over texels of the covered fraction.
double area(const Coverage& coverage, uint32_t samples) {
    double sum =
        static_cast<double>(coverage.owners.size()) -
        static_cast<double>(std::count(coverage.owners.begin(), coverage.owners.end(), none));
    for (const Coverage::EdgeTexel& edge : coverage.edges)
        sum += static_cast<double>(edge.count) / samples;
    return sum;
}

TEST(UvRaster, SamplesMeasureTheBorderOfAnIsland) {
    const std::vector<Corner> t = {{100, 90}, {813, 210}, {340, 777}};
    const double exact =
        std::abs((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x)) /
        2.0 / (parts * parts);
    double error = std::abs(area(cover(mesh_of(t), 1), 1) - exact);
    EXPECT_LT(error, 10);
    for (const uint32_t samples : {4U, 16U, 64U})
        EXPECT_NEAR(area(cover(mesh_of(t), samples), samples), exact, 30.0 / samples) << samples;
}

TEST(UvRaster, EveryOwnerOfASampleCoversIt) {
    const auto corners = torn_grid(5, 150, 3);  // ends within texels
    const Coverage got = cover(mesh_of(corners), 16);
    ASSERT_FALSE(got.edges.empty());
    std::set<uint32_t> seen;
    for (const Coverage::EdgeTexel& edge : got.edges) {
        EXPECT_EQ(got.owners[edge.texel], none);
        EXPECT_LE(edge.count, 16U);
        EXPECT_TRUE(seen.insert(edge.texel).second);
        for (uint32_t i = edge.first; i < edge.first + edge.count; ++i) {
            const UvSample& sample = got.samples[i];
            EXPECT_EQ(static_cast<uint32_t>(sample.position.x), edge.texel % side);
            EXPECT_EQ(static_cast<uint32_t>(sample.position.y), edge.texel / side);
            EXPECT_NE(side_of(&corners[3 * size_t{sample.triangle}],
                              static_cast<int>(sample.position.x * parts),
                              static_cast<int>(sample.position.y * parts)),
                      Side::outside);
        }
    }
    // No texel inside of the island is an edge texel.
    for (const Coverage::EdgeTexel& edge : got.edges) {
        const uint32_t x = edge.texel % side, y = edge.texel / side;
        EXPECT_TRUE(x < 2 || y < 2 || x > 44 || y > 44) << x << ", " << y;
    }
}

TEST(UvRaster, MeetsAnIslandThinnerThanATexel) {
    const Mesh sliver = mesh_of({{17, 17}, {17 + 900, 17}, {17, 17 + 5}});
    const Coverage coarse = cover(sliver), fine = cover(sliver, 16);
    EXPECT_EQ(area(coarse, 1), 0);
    EXPECT_GT(fine.edges.size(), 30U);
}

TEST(UvRaster, IslandsThatFoldBackHaveABorderAtTheFold) {
    const Mesh folded =
        mesh_of({{100, 100}, {500, 104}, {100, 500}, {100, 100}, {500, 104}, {90, 400}});
    const Coverage got = cover(folded, 16);
    const uint32_t texel = 6 * side + 20;  // on the fold
    EXPECT_TRUE(std::any_of(got.edges.begin(), got.edges.end(),
                            [&](const auto& edge) { return edge.texel == texel; }));
}

TEST(UvRaster, PartsAreThoseOfTheWhole) {
    const Mesh mesh = mesh_of(torn_grid(5, 150, 3));
    const Coverage whole = cover(mesh, 4);
    size_t edges = 0;
    for (uint32_t y = 0; y < side; y += 16)
        for (uint32_t x = 0; x < side; x += 20) {
            const TexelRect rect = {x, y, std::min(20U, side - x), 16};
            const Coverage part = cover(mesh, rect, 4);
            edges += part.edges.size();
            for (uint32_t i = 0; i < part.owners.size(); ++i)
                EXPECT_EQ(part.owners[i],
                          whole.owners[(y + i / rect.width) * side + x + i % rect.width]);
        }
    EXPECT_EQ(edges, whole.edges.size());
}

TEST(UvRaster, ATileOfUdimIsTheSamePlaceMoved) {
    const Mesh mesh = mesh_of(torn_grid(8, 100, 9));
    Mesh moved = mesh;
    for (glm::vec2& uv : moved.uvs[0])
        uv += glm::vec2(3, 2);
    EXPECT_EQ(cover(moved, {0, 0, side, side}, 4, {3, 2}).owners, cover(mesh, 4).owners);
    EXPECT_EQ(area(cover(moved), 1), 0);
}

TEST(UvRaster, WhatHasNoAreaOrIsFarAwayOwnsNothing) {
    Mesh mesh = mesh_of({{10, 10}, {500, 500}, {900, 900}});
    EXPECT_EQ(area(cover(mesh, 16), 16), 0);
    const float big = std::numeric_limits<float>::max();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float u : {big, -big, 1e9F, nan}) {
        mesh = mesh_of({{10, 10}, {500, 10}, {10, 500}});
        mesh.uvs[0][1].x = u;
        EXPECT_EQ(area(cover(mesh, 16), 16), 0) << u;
    }
}

TEST(UvRaster, ShapesCoverTheirLayoutsOnce) {
    for (const Shape& shape : shapes()) {
        const Coverage got = cover(shape.make(), 4);
        EXPECT_EQ(got.overlapped, 0U) << shape.name;
        EXPECT_GT(area(got, 4), 0.3 * side * side) << shape.name;
    }
}

}  // namespace
}  // namespace wrinkle
