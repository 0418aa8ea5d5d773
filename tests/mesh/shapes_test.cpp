#include "mesh/shapes.h"
#include "support/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <tuple>

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;
constexpr double pi = std::numbers::pi;

class EveryShape : public testing::TestWithParam<std::string_view> {
protected:
    Mesh mesh = *make_shape(GetParam());
};

std::string shape_name(const testing::TestParamInfo<std::string_view>& info) {
    return std::string(info.param);
}

// teapot_test.cpp tests the teapot.
INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape,
                         testing::Values("sphere", "plane", "cube", "cylinder", "torus"),
                         shape_name);

dvec3 corner(const Mesh& mesh, size_t index) {
    return mesh.positions[mesh.indices[index]];
}

dvec3 area_vector(const Mesh& mesh, size_t t) {
    const dvec3 a = corner(mesh, 3 * t);
    return glm::cross(corner(mesh, 3 * t + 1) - a, corner(mesh, 3 * t + 2) - a) * 0.5;
}

double uv_area(const Mesh& mesh, size_t t) {
    const auto uv = [&](size_t k) { return dvec2(mesh.uvs[0][mesh.indices[3 * t + k]]); };
    const dvec2 a = uv(1) - uv(0);
    const dvec2 b = uv(2) - uv(0);
    return (a.x * b.y - a.y * b.x) / 2;
}

TEST(Shapes, AreListedByName) {
    ASSERT_EQ(shapes().size(), 6U);
    EXPECT_EQ(shapes().front().name, "sphere");
    for (const Shape& shape : shapes())
        EXPECT_FALSE(shape.doc.empty());
    EXPECT_FALSE(make_shape("kettle"));
    EXPECT_FALSE(make_shape(""));
}

TEST_P(EveryShape, HasAllAttributesForEveryVertex) {
    const size_t count = mesh.vertex_count();
    EXPECT_EQ(mesh.normals.size(), count);
    EXPECT_EQ(mesh.tangents.size(), count);
    EXPECT_EQ(mesh.uvs[0].size(), count);
    EXPECT_EQ(mesh.uvs[1].size(), count);
    EXPECT_FALSE(mesh.has_uv(2));
    EXPECT_FALSE(mesh.has_uv(3));
    EXPECT_EQ(mesh.colors.size(), count);
    ASSERT_EQ(mesh.indices.size() % 3, 0U);
    std::vector<bool> used(count);
    for (uint32_t index : mesh.indices) {
        ASSERT_LT(index, count);
        used[index] = true;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << "vertices without a triangle";
}

TEST_P(EveryShape, HasUnitFramesThatFaceOutwards) {
    for (size_t v = 0; v < mesh.vertex_count(); ++v) {
        const dvec3 n = mesh.normals[v];
        const dvec3 t = mesh.tangents[v];
        ASSERT_NEAR(glm::length(n), 1, 1e-6);
        ASSERT_NEAR(glm::length(t), 1, 1e-6);
        ASSERT_NEAR(glm::dot(n, t), 0, 1e-6);
        ASSERT_EQ(mesh.tangents[v].w, 1);
    }
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const dvec3 face = glm::normalize(area_vector(mesh, i / 3));
        ASSERT_GT(glm::dot(face, dvec3(mesh.normals[mesh.indices[i]])), 0.99)
            << "triangle " << i / 3;
    }
}

using Point = std::tuple<float, float, float>;

TEST_P(EveryShape, IsClosed) {
    std::map<std::pair<Point, Point>, int> edges;
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const auto point = [&](size_t k) {
            const glm::vec3 p = mesh.positions[mesh.indices[k]] + 0.0F;  // no negative zero
            return Point(p.x, p.y, p.z);
        };
        ASSERT_NE(point(i), point(next)) << "an edge without length";
        ++edges[{point(i), point(next)}];
    }
    int open = 0;
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        open += edges.contains({edge.second, edge.first}) ? 0 : 1;
    }
    EXPECT_EQ(open, GetParam() == "plane" ? 4 : 0);
}

// The divergence theorem is independent of the construction of the shapes.
TEST_P(EveryShape, HasTheDocumentedSize) {
    double volume = 0;
    double area = 0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        volume += glm::dot(corner(mesh, 3 * t), area_vector(mesh, t)) / 3;
        area += glm::length(area_vector(mesh, t));
    }
    const std::map<std::string_view, std::pair<double, double>> expected{
        {"sphere", {4 * pi / 3, 4 * pi}},
        {"plane", {0, 4}},
        {"cube", {8, 24}},
        {"cylinder", {2 * pi, 6 * pi}},
        {"torus", {2 * pi * pi * 0.7 * 0.3 * 0.3, 4 * pi * pi * 0.7 * 0.3}}};
    EXPECT_NEAR(volume, expected.at(GetParam()).first, 0.005 * volume);
    EXPECT_NEAR(area, expected.at(GetParam()).second, 0.005 * area);
    EXPECT_LT(glm::length(bounds_of(mesh).center()), 1e-6);
}

TEST_P(EveryShape, LaysItsUvsOutOnceWithinTheSquare) {
    for (const glm::vec2 uv : mesh.uvs[0]) {
        ASSERT_GE(std::min(uv.x, uv.y), 0);
        ASSERT_LE(std::max(uv.x, uv.y), 1);
    }
    double total = 0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        ASSERT_GT(uv_area(mesh, t), 0) << "triangle " << t;
        total += uv_area(mesh, t);
    }
    // A fine raster of points hits each triangle in proportion to its area; if two overlapped,
    // fewer points would be covered than the sum of the areas.
    int covered = 0;
    constexpr int side = 20;
    for (int i = 0; i < side * side; ++i) {
        const dvec2 uv((i % side + 0.5) / side, (i / side + 0.5) / side);
        covered += test::sample_surface(mesh, uv, 1) ? 1 : 0;
    }
    EXPECT_NEAR(covered / static_cast<double>(side * side), total, 0.03);
}

TEST_P(EveryShape, HasTangentsAlongItsUvs) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0.02, 0.98);
    int tried = 0;
    for (int draws = 0; tried < 40; ++draws) {
        ASSERT_LT(draws, 4000) << "hardly a place of the uv square is on the mesh";
        const dvec2 uv(anywhere(random), anywhere(random));
        constexpr double h = 0.004;
        const auto at = [&](dvec2 offset) { return test::sample_surface(mesh, uv + offset, 1); };
        const auto middle = at({0, 0});
        const auto left = at({-h, 0});
        const auto right = at({h, 0});
        const auto down = at({0, -h});
        const auto up = at({0, h});
        if (!middle || !left || !right || !down || !up) continue;
        ++tried;
        const dvec3 n = middle->value.normal;
        const dvec3 t = dvec3(middle->value.tangent);
        const dvec3 b = middle->value.tangent.w * glm::cross(n, t);
        if (glm::length(left->value.normal - right->value.normal) > 0.5) continue;  // another face
        if (glm::length(up->value.normal - down->value.normal) > 0.5) continue;
        const dvec3 du = right->value.position - left->value.position;
        const dvec3 dv = up->value.position - down->value.position;
        EXPECT_GT(glm::dot(glm::normalize(du), glm::normalize(t)), 0.995) << uv.x << " " << uv.y;
        EXPECT_GT(glm::dot(glm::normalize(dv), glm::normalize(b)), 0.995) << uv.x << " " << uv.y;
    }
}

TEST_P(EveryShape, HasASecondUvSetTurnedAndTwiceAsDense) {
    for (size_t v = 0; v < mesh.vertex_count(); ++v) {
        const dvec2 p = dvec2(mesh.uvs[0][v]) - 0.5;
        const dvec2 q = dvec2(mesh.uvs[1][v]) - 0.5;
        ASSERT_NEAR(glm::length(q), 2 * glm::length(p), 1e-6);
        ASSERT_NEAR(p.x * q.y - p.y * q.x, glm::length(p) * glm::length(q) / 2, 1e-6);  // sin 30
        ASSERT_GE(glm::dot(p, q), 0);
    }
}

struct Place {
    std::string_view shape;
    dvec2 uv;
    dvec3 position;
};

// Spot checks of the uvs that the header documents.
TEST(Shapes, PutUvsWhereTheHeaderSays) {
    const std::vector<Place> places{{"sphere", {0.5, 0.5}, {0, 0, 1}},
                                    {"sphere", {0.75, 0.5}, {1, 0, 0}},
                                    {"sphere", {0, 0.5}, {0, 0, -1}},
                                    {"plane", {0, 0}, {-1, -1, 0}},
                                    {"plane", {1, 0.5}, {1, 0, 0}},
                                    {"cube", {1 / 6.0, 1 / 6.0}, {1, 0, 0}},
                                    {"cube", {0.5, 1 / 6.0}, {0, 1, 0}},
                                    {"cube", {5 / 6.0, 1 / 6.0}, {0, 0, 1}},
                                    {"cube", {1 / 6.0, 0.5}, {-1, 0, 0}},
                                    {"cube", {0.5, 0.5}, {0, -1, 0}},
                                    {"cube", {5 / 6.0, 0.5}, {0, 0, -1}},
                                    {"cube", {0.25, 1 / 6.0}, {1, 0, -0.5}},
                                    {"cube", {0.5, 0.25}, {0, 1, -0.5}},
                                    {"cube", {11 / 12.0, 0.25}, {0.5, 0.5, 1}},
                                    {"cube", {0.25, 7 / 12.0}, {-1, 0.5, 0.5}},
                                    {"cube", {7 / 12.0, 7 / 12.0}, {0.5, -1, 0.5}},
                                    {"cube", {11 / 12.0, 0.5}, {-0.5, 0, -1}},
                                    {"cylinder", {0.5, 0}, {0, -1, 1}},
                                    {"cylinder", {0.75, 0.5}, {1, 1, 0}},
                                    {"cylinder", {0.25, 0.75}, {0, 1, 0}},
                                    {"cylinder", {0.75, 0.75}, {0, -1, 0}},
                                    {"torus", {0.5, 0.5}, {0, 0, 1}},
                                    {"torus", {0.5, 0.75}, {0, 0.3, 0.7}},
                                    {"torus", {0.75, 0}, {0.4, 0, 0}}};
    for (const Place& place : places) {
        const auto point = test::sample_surface(*make_shape(place.shape), place.uv, 1);
        ASSERT_TRUE(point) << place.shape;
        EXPECT_LT(glm::length(point->value.position - place.position), 1e-5)
            << place.shape << " at " << place.uv.x << " " << place.uv.y;
    }
}

}  // namespace
}  // namespace wrinkle
