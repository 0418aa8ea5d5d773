#include "mesh/sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "mesh/shapes.h"
#include "support/surface.h"

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

using test::sample_surface;

TEST(SampleMesh, GivesTheDifferentialsOfOneTexel) {
    const auto point = sample_surface(*make_shape("plane"), {0.25, 0.75}, 512);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->value.position, dvec3(-0.5, 0.5, 0));
    EXPECT_EQ(point->value.normal, dvec3(0, 0, 1));
    EXPECT_EQ(point->value.tangent, glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(point->dx.position, dvec3(2.0 / 512, 0, 0));
    EXPECT_EQ(point->dy.position, dvec3(0, 2.0 / 512, 0));
    EXPECT_EQ(point->dx.uv[0], dvec2(1.0 / 512, 0));
    EXPECT_EQ(point->dy.uv[0], dvec2(0, 1.0 / 512));
    EXPECT_EQ(point->dx.normal, dvec3(0));
    EXPECT_EQ(point->dy.color, glm::dvec4(0));
    // uv1 is rotated by 30 degrees and scaled by 2.
    EXPECT_NEAR(point->dx.uv[1].x, std::sqrt(3.0) / 512, 1e-8);
    EXPECT_NEAR(point->dx.uv[1].y, 1.0 / 512, 1e-8);
}

TEST(SampleMesh, DifferentialsAreDifferencesOfPoints) {
    const Mesh mesh = *make_shape("torus");
    const dvec2 uv(0.3704, 0.6103);
    constexpr uint32_t size = 1 << 16;  // a texel well inside the triangle
    const auto here = sample_surface(mesh, uv, size);
    const auto right = sample_surface(mesh, uv + dvec2(1.0 / size, 0), size);
    const auto up = sample_surface(mesh, uv + dvec2(0, 1.0 / size), size);
    ASSERT_TRUE(here && right && up);
    ASSERT_EQ(here->triangle, right->triangle);
    ASSERT_EQ(here->triangle, up->triangle);
    const auto near = [](auto a, auto b) { return glm::length(a - b) < 1e-14; };
    EXPECT_TRUE(near(here->dx.position, right->value.position - here->value.position));
    EXPECT_TRUE(near(here->dy.position, up->value.position - here->value.position));
    EXPECT_TRUE(near(here->dx.normal, right->value.normal - here->value.normal));
    EXPECT_TRUE(near(here->dy.normal, up->value.normal - here->value.normal));
    EXPECT_TRUE(near(here->dx.tangent, right->value.tangent - here->value.tangent));
    EXPECT_TRUE(near(here->dy.uv[1], up->value.uv[1] - here->value.uv[1]));
}

// uv0 is exact, not interpolated from the corners' floats: a bake reads textures at it, with one
// mip level for all texels.
TEST(SampleMesh, TheFirstUvIsThePlaceToTheLastBit) {
    const Mesh mesh = *make_shape("torus");
    for (const dvec2 uv : {dvec2(0.3704, 0.6103), dvec2(0.1, 0.7), dvec2(1 / 3.0, 1 / 7.0)}) {
        const auto point = sample_surface(mesh, uv, 1000);
        ASSERT_TRUE(point);
        EXPECT_EQ(point->value.uv[0], uv);
        EXPECT_EQ(point->dx.uv[0], dvec2(1.0 / 1000, 0));
        EXPECT_EQ(point->dy.uv[0], dvec2(0, 1.0 / 1000));
    }
}

TEST(SampleMesh, CoversEdgesAndCorners) {
    const Mesh cube = *make_shape("cube");
    for (const dvec2 uv :
         {dvec2(0, 0), dvec2(1 / 3.0, 1 / 3.0), dvec2(1, 0), dvec2(0.5, 1 / 3.0)}) {
        EXPECT_TRUE(sample_surface(cube, uv, 1024)) << uv.x << " " << uv.y;
    }
}

TEST(SampleMesh, GivesZeroForWhatTheMeshLacks) {
    Mesh mesh = *make_shape("plane");
    mesh.tangents.clear();
    mesh.uvs[1].clear();
    const auto point = sample_surface(mesh, {0.5, 0.5}, 1024);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->value.tangent, glm::dvec4(0));
    EXPECT_EQ(point->value.uv[1], dvec2(0));
    EXPECT_EQ(point->value.color, glm::dvec4(1));
}

TEST(SampleMesh, RefusesPlacesOutsideTheLayout) {
    const Mesh cube = *make_shape("cube");
    EXPECT_FALSE(sample_surface(cube, {0.5, 0.9}, 1024));
    EXPECT_FALSE(sample_surface(cube, {-0.1, 0.1}, 1024));
    EXPECT_FALSE(sample_surface(cube, {std::numeric_limits<double>::quiet_NaN(), 0.5}, 1024));
    EXPECT_FALSE(sample_surface(cube, {std::numeric_limits<double>::infinity(), 0.5}, 1024));
    Mesh collapsed = *make_shape("plane");
    collapsed.uvs[0].assign(collapsed.vertex_count(), glm::vec2(0.5F));
    EXPECT_FALSE(sample_surface(collapsed, {0.5, 0.5}, 1024));
}

}  // namespace
}  // namespace wrinkle
