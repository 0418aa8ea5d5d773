// Tests of the views of a material: the value of each, and its displayed color.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fixture.h"

namespace wrinkle::gpu {
namespace {

using glm::vec3;
using ViewTest = WithRenderer;

TEST_F(ViewTest, ADisplacedMeshKeepsTheSurfaceOfItsMaterial) {
    Mesh mesh = *make_shape("sphere");
    for (const glm::vec3& position : mesh.positions)
        mesh.displaced.push_back(position * 0.5F);
    const Shader where =
        material_with_normal("s.position", {{"position", Type::vec3_, SurfaceInput::position_}});
    const size_t whole = covered(draw(where, View::normal));
    renderer->set_mesh(mesh);
    const std::vector<Pixel> small = draw(View::normal);
    EXPECT_NEAR(static_cast<double>(covered(small)), 0.25 * static_cast<double>(whole),
                0.03 * static_cast<double>(whole));
    for (const Pixel& pixel : small) {
        if (!pixel.covered) continue;
        EXPECT_NEAR(glm::length(pixel.value), 1, 1e-2);
    }
}

TEST_F(ViewTest, FindsTheGradientInTheNormal) {
    const auto normals = draw(Shader{}, View::normal);
    const auto gradients = draw(tilted(), View::gradient);
    for (size_t i = 0; i < normals.size(); ++i) {
        if (!normals[i].covered) continue;
        const vec3 along = glm::normalize(glm::cross(normals[i].value, vec3(0, 1, 0)));
        ASSERT_LT(glm::distance(gradients[i].value, 0.3F * along), 1e-4);
    }
}

TEST_F(ViewTest, MeasuresTheDifferenceInDegrees) {
    ASSERT_TRUE(renderer->set_material(tilted(), diagnostics)) << errors();
    const double expected = std::atan(0.3) * 180 / std::numbers::pi;
    const auto bump = renderer->measure(scene, "", 64, 64, diagnostics);
    ASSERT_TRUE(bump) << errors();
    EXPECT_NEAR(bump->mean_degrees, expected, 1e-3);
    EXPECT_NEAR(bump->max_degrees, expected, 1e-2);
    EXPECT_EQ(bump->pixels, covered(draw(View::normal)));
    const auto other = renderer->measure(scene, "unbumped", 64, 64, diagnostics);
    ASSERT_TRUE(other) << errors();
    EXPECT_NEAR(other->mean_degrees, expected, 1e-3);
    const auto self = renderer->measure(scene, "normal", 64, 64, diagnostics);
    ASSERT_TRUE(self) << errors();
    EXPECT_LT(self->max_degrees, 1e-3);
}

TEST_F(ViewTest, ShowsHeightAndUvAsTheyAre) {
    const auto normals = draw(Shader{}, View::normal);
    const auto heights = draw(tilted(), View::height);
    for (size_t i = 0; i < normals.size(); ++i)
        ASSERT_NEAR(heights[i].value.x, 7 * normals[i].value.y, 0.02);
    show("plane");
    for (const Pixel& pixel : draw(View::uv))
        if (pixel.covered) {
            ASSERT_GE(std::min(pixel.value.x, pixel.value.y), 0);
            ASSERT_LE(std::max(pixel.value.x, pixel.value.y), 1);
        }
}

TEST_F(ViewTest, StretchesHeightsOverTheGraysUnlessToldARange) {
    ASSERT_TRUE(renderer->set_material(tilted(), diagnostics)) << errors();
    const auto shown = Target::make({size, size}, diagnostics);
    const auto grays = [&](glm::vec2 range) {
        ViewOptions options;
        options.view = View::height;
        options.height_range = range;
        EXPECT_TRUE(renderer->draw(scene, options, *shown, diagnostics)) << errors();
        return shown->read();
    };
    const auto heights = draw(View::height);
    float low = 1e9F;
    float high = -1e9F;
    for (const Pixel& pixel : heights) {
        low = std::min(low, pixel.covered ? pixel.value.x : low);
        high = std::max(high, pixel.covered ? pixel.value.x : high);
    }
    const std::vector<float> own = grays({0, 0});
    const std::vector<float> given = grays({-7, 14});
    for (size_t i = 0; i < heights.size(); ++i) {
        if (!heights[i].covered) continue;
        const float h = heights[i].value.x;
        ASSERT_NEAR(own[4 * i], (h - low) / (high - low), 0.6 / 255);
        ASSERT_NEAR(given[4 * i + 2], (h + 7) / 21, 0.6 / 255);
    }
    ASSERT_TRUE(renderer->set_material(tilted("3.0"), diagnostics)) << errors();
    EXPECT_NEAR(grays({0, 0})[4 * (32 * 64 + 32)], 0.5F, 0.6 / 255);
}

// The tone curve that the header documents.
float displayed(float radiance) {
    const float beyond = std::max(radiance - 0.8F, 0.0F);
    const float c = std::min(radiance, 0.8F) + 0.2F * beyond / (beyond + 0.2F);
    return c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1 / 2.4F) - 0.055F;
}

TEST_F(ViewTest, MakesColorsAsTheHeaderSays) {
    scene.light = 3;
    const auto values = draw(Shader{}, View::shaded);
    const auto shown = Target::make({size, size}, diagnostics);
    ASSERT_TRUE(shown) << errors();
    ASSERT_TRUE(renderer->draw(scene, {}, *shown, diagnostics)) << errors();
    const std::vector<float> pixels = shown->read();
    bool bright = false;
    for (size_t i = 0; i < values.size(); ++i) {
        const vec3 color(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]);
        const float expected =
            values[i].covered ? displayed(values[i].value.g) : scene.background.g;
        ASSERT_NEAR(color.g, expected, 0.6 / 255);
        ASSERT_EQ(pixels[4 * i + 3], 1);
        bright = bright || values[i].value.g > 1.2F;
    }
    EXPECT_TRUE(bright) << "the shoulder was not reached";
}

TEST_F(ViewTest, HeatMapRunsFromDarkBlueToYellow) {
    const auto shown = Target::make({size, size}, diagnostics);
    ASSERT_TRUE(renderer->set_material(tilted(), diagnostics)) << errors();
    const float angle = std::atan(0.3F) * 180 / std::numbers::pi_v<float>;
    // #123570 and #C3B369 of the published table, halfway between #707173 and #8A8678, and its end.
    const std::vector<std::pair<float, vec3>> cases{{9, {18, 53, 112}},
                                                    {9 / 7.0F, {195, 179, 105}},
                                                    {2, {125, 123.5, 117.5}},
                                                    {1, {254, 232, 56}},
                                                    {0.1F, {254, 232, 56}}};
    for (const auto& [factor, bytes] : cases) {
        const vec3 expected = bytes / 255.0F;
        ViewOptions options;
        options.view = View::difference;
        options.heat_degrees = angle * factor;
        ASSERT_TRUE(renderer->draw(scene, options, *shown, diagnostics)) << errors();
        const std::vector<float> pixels = shown->read();
        const float* middle = pixels.data() + 4 * (32 * 64 + 32);
        EXPECT_LT(glm::distance(vec3(middle[0], middle[1], middle[2]), expected), 0.02F) << factor;
    }
}

TEST_F(ViewTest, WireframeShowsEdgesOnTriangles) {
    Mesh mesh = *make_shape("plane");
    mesh.indices = {0, 1, static_cast<uint32_t>(mesh.vertex_count() - 1)};
    renderer->set_mesh(mesh);
    size_t edges = 0, faces = 0;
    for (const auto& pixel : draw(Shader{}, View::wireframe)) {
        if (!pixel.covered) continue;
        EXPECT_TRUE(pixel.value.r == 0 || pixel.value.r == 1) << pixel.value.r;
        (pixel.value.r > 0 ? edges : faces) += 1;
    }
    EXPECT_GT(edges, 50U);
    EXPECT_GT(faces, 50U);
    EXPECT_GE(covered(draw(Shader{}, View::uv)), faces) << "the next view fills no triangles";
}

TEST_F(ViewTest, AnotherOutputReplacesTheNormal) {
    const Shader two = tilted();
    const auto flat = draw(tilted(), View::difference);
    ViewOptions options;
    options.view = View::difference;
    options.normal = "unbumped";
    options.raw = true;
    const auto numbers = Target::make({size, size, PixelFormat::rgba32f}, diagnostics);
    ASSERT_TRUE(renderer->set_material(two, diagnostics)) << errors();
    const uint64_t linked = renderer->programs_linked();
    ASSERT_TRUE(renderer->draw(scene, options, *numbers, diagnostics)) << errors();
    ASSERT_TRUE(renderer->draw(scene, options, *numbers, diagnostics)) << errors();
    EXPECT_EQ(renderer->programs_linked(), linked + 1);
    const std::vector<float> pixels = numbers->read();
    const size_t middle = 32 * 64 + 32;
    EXPECT_GT(flat[middle].value.r, 10) << "this material's own normal is tilted";
    EXPECT_LT(pixels[4 * middle], 0.01F);
    options.normal = "missing";
    EXPECT_FALSE(renderer->draw(scene, options, *numbers, diagnostics));
}

}  // namespace
}  // namespace wrinkle::gpu
