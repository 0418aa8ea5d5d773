// Tests of the teapot against facts known without its code: published control points on it, its
// size, the area of its body by Pappus's theorem, and its outward orientation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh/shapes.h"
#include "mesh/vertex_frames.h"
#include "support/surface.h"

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

class Teapot : public testing::Test {
protected:
    dvec3 at(dvec2 uv, dvec3* normal = nullptr) const {
        const auto point = test::sample_surface(mesh, uv, 1024);
        EXPECT_TRUE(point);
        if (normal && point) *normal = glm::normalize(point->value.normal);
        return point ? point->value.position : dvec3(0);
    }

    // Converts a point in published coordinates (z up) to those of the mesh.
    static dvec3 published(dvec3 p, dvec3 origin) { return 0.45 * dvec3(p.x, p.z, -p.y) - origin; }

    Mesh mesh = *make_shape("teapot");
    Bounds bounds = bounds_of(mesh);
};

// The corners of patches lie on the surface; these are some of the published ones.
TEST_F(Teapot, GoesThroughThePublishedCorners) {
    const dvec3 foot = at({0.5, 0.14});  // published (0, -1.5, 0.15)
    const dvec3 origin = -dvec3(foot.x, bounds.low.y, 0);
    const auto expect = [&](dvec2 uv, dvec3 corner) {
        const dvec3 found = at(uv), wanted = published(corner, origin);
        EXPECT_LT(glm::length(found - wanted), 1e-4)
            << uv.x << " " << uv.y << ": " << found.x << " " << found.y << " " << found.z
            << ", not " << wanted.x << " " << wanted.y << " " << wanted.z;
    };
    expect({0.75, 0.14}, {1.5, 0, 0.15});
    expect({0.25, 0.26}, {-2, 0, 0.9});
    expect({0.5, 0.26}, {0, -2, 0.9});
    expect({0.75, 0.48}, {1.5, 0, 2.4});
    expect({0.5, 0.54}, {0, -1.4, 2.4});
    expect({0.75, 0.56}, {1.3, 0, 2.4});
    expect({0.5, 0.70}, {0, -0.2, 2.7});
    expect({0, 0.84}, {-1.6, 0, 2.025});
    expect({0.245, 0.84}, {-2.7, 0, 1.8});
    expect({0.245, 0.92}, {-3, 0, 1.8});
    expect({0.49, 0.92}, {-1.9, 0, 0.6});
    expect({0.51, 0.84}, {1.7, 0, 1.425});
    expect({0.755, 0.92}, {3.3, 0, 2.4});
    expect({1, 0.84}, {2.8, 0, 2.4});
}

TEST_F(Teapot, HasThePublishedSize) {
    EXPECT_NEAR(bounds.high.y - bounds.low.y, 0.45 * 3.15, 1e-5);
    EXPECT_LT(glm::length(bounds.center()), 1e-6);
    EXPECT_NEAR(bounds.high.z - bounds.low.z, 0.45 * 4, 0.01);
    // A Bezier curve lies in the convex hull of its control points.
    EXPECT_LT(bounds.high.x - bounds.low.x, 0.45 * 6.525);
    EXPECT_GT(bounds.high.x - bounds.low.x, 0.45 * 6.2);
    EXPECT_GT(mesh.triangle_count(), 8000U);
}

// Integrates the profile curves numerically: the area of a surface of revolution is the integral of
// 2 pi r; a ring of control points at 0.56 deviates from a circle by less than one per cent.
TEST_F(Teapot, HasABodyOfRevolution) {
    double area = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const float v = mesh.uvs[0][mesh.indices[i]].y;
        if (v >= 0.14F - 1e-6F && v <= 0.48F && mesh.uvs[0][mesh.indices[i + 2]].y <= 0.48F) {
            const dvec3 a = mesh.positions[mesh.indices[i]];
            area += glm::length(glm::cross(dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                           dvec3(mesh.positions[mesh.indices[i + 2]]) - a)) /
                    2;
        }
    }
    double expected = 0;
    const dvec2 profiles[2][4] = {{{1.5, 0.15}, {1.5, 0.225}, {2, 0.45}, {2, 0.9}},
                                  {{2, 0.9}, {2, 1.35}, {1.75, 1.875}, {1.5, 2.4}}};
    for (const auto& p : profiles) {
        dvec2 before = p[0];
        for (int i = 1; i <= 1000; ++i) {
            const double t = i / 1000.0, s = 1 - t;
            const dvec2 now =
                s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
            expected += std::numbers::pi * (now.x + before.x) * glm::length(now - before);
            before = now;
        }
    }
    EXPECT_NEAR(area / (0.45 * 0.45 * expected), 1, 0.01);
}

TEST_F(Teapot, FacesOutwardsWithUnitFrames) {
    for (size_t v = 0; v < mesh.vertex_count(); ++v) {
        ASSERT_NEAR(glm::length(mesh.normals[v]), 1, 1e-5);
        ASSERT_NEAR(glm::length(glm::vec3(mesh.tangents[v])), 1, 1e-5);
        ASSERT_NEAR(glm::dot(glm::vec3(mesh.tangents[v]), mesh.normals[v]), 0, 1e-5);
        ASSERT_EQ(mesh.tangents[v].w, 1);
    }
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const dvec3 a = mesh.positions[mesh.indices[i]];
        const dvec3 face = glm::cross(dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                      dvec3(mesh.positions[mesh.indices[i + 2]]) - a);
        ASSERT_GT(glm::length(face), 0) << i / 3;
        for (size_t k = 0; k < 3; ++k)
            ASSERT_GT(glm::dot(glm::normalize(face), dvec3(mesh.normals[mesh.indices[i + k]])), 0.7)
                << i / 3;
    }
    dvec3 normal;
    at({0.5, 0.26}, &normal);
    EXPECT_LT(glm::length(normal - dvec3(0, 0, 1)), 1e-3);
    at({0.245, 0.92}, &normal);
    EXPECT_LT(glm::length(normal - dvec3(-1, 0, 0)), 1e-2) << "the handle's back";
    at({0.755, 0.92}, &normal);
    EXPECT_GT(normal.x, 0.3) << "the spout's front";
    at({0.755, 0.84}, &normal);
    EXPECT_LT(normal.x, -0.5) << "the spout's back";
    at({32.5 / 64, 0.002}, &normal);
    EXPECT_LT(glm::length(normal - dvec3(0, -1, 0)), 1e-2) << "the bottom";
}

TEST_F(Teapot, LaysItsUvsOutOnce) {
    double total = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const dvec2 a = mesh.uvs[0][mesh.indices[i]];
        const dvec2 b = dvec2(mesh.uvs[0][mesh.indices[i + 1]]) - a;
        const dvec2 c = dvec2(mesh.uvs[0][mesh.indices[i + 2]]) - a;
        ASSERT_GT(b.x * c.y - b.y * c.x, 0) << i / 3;
        total += (b.x * c.y - b.y * c.x) / 2;
    }
    int covered = 0;
    constexpr int side = 25;
    for (int i = 0; i < side * side; ++i) {
        const dvec2 uv((i % side + 0.5) / side, (i / side + 0.5) / side);
        covered += test::sample_surface(mesh, uv, 1) ? 1 : 0;
    }
    EXPECT_NEAR(covered / static_cast<double>(side * side), total, 0.04);
}

}  // namespace
}  // namespace wrinkle
