// Tests that lookups in the grid agree with a search through all triangles.
#include "mesh/uv_grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "mesh/shapes.h"
#include "support/surface.h"

namespace wrinkle {
namespace {

void expect_same(const Mesh& mesh, glm::dvec2 low, glm::dvec2 high) {
    const UvGrid grid(mesh);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-0.1, 1.1);
    for (int i = 0; i < 300; ++i) {
        glm::dvec2 uv(low.x + part(random) * (high.x - low.x),
                      low.y + part(random) * (high.y - low.y));
        if (i % 3 == 0) uv = mesh.uvs[0][random() % mesh.uvs[0].size()];  // a random mesh vertex
        const auto searched = test::sample_surface(mesh, uv, 512);
        const auto found = sample_mesh(mesh, grid.near(uv), uv, 512);
        ASSERT_EQ(searched.has_value(), found.has_value()) << uv.x << " " << uv.y;
        if (!found) continue;
        EXPECT_EQ(searched->triangle, found->triangle);
        EXPECT_EQ(searched->value.position, found->value.position);
        EXPECT_EQ(searched->dy.normal, found->dy.normal);
    }
}

TEST(UvGrid, FindsWhatTheSearchFinds) {
    for (const Shape& shape : shapes())
        expect_same(shape.make(), {0, 0}, {1, 1});
}

// Large triangles over small ones; some have no area or a NaN uv.
TEST(UvGrid, FindsWhatTheSearchFindsInLayoutsThatOverlap) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-2, 5), small(-0.05F, 0.05F);
    Mesh mesh;
    for (uint32_t i = 0; i < 600; ++i) {
        const glm::vec2 middle(place(random), place(random));
        for (int k = 0; k < 3; ++k) {
            glm::vec2 uv = middle + glm::vec2(small(random), small(random));
            if (i % 5 == 0) uv = {place(random), place(random)};
            if (i % 50 == 1) uv = middle;
            if (i % 50 == 2) uv.x = std::numeric_limits<float>::quiet_NaN();
            mesh.positions.emplace_back(uv, place(random));
            mesh.uvs[0].push_back(uv);
            mesh.indices.push_back(3 * i + static_cast<uint32_t>(k));
        }
    }
    expect_same(mesh, {-2, -2}, {5, 5});
    Mesh none = mesh;
    none.indices.resize(3);
    none.uvs[0][0] = none.uvs[0][1] = none.uvs[0][2];
    EXPECT_FALSE(sample_mesh(none, UvGrid(none).near({0, 0}), {0, 0}, 8));
}

}  // namespace
}  // namespace wrinkle
