// Tests of the views of a material: the value of each, and its displayed color.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

// Bytes of linear values, from the reference implementations: the Khronos PBR Neutral
// specification and AgX of three.js.
TEST_F(ViewTest, ToneCurvesGoThroughTheirAnchors) {
    const auto shown = Target::make({size, size}, diagnostics);
    ASSERT_TRUE(shown) << errors();
    scene.environment = 0;
    struct Anchor {
        Tone tone;
        const char* radiance;
        std::array<float, 3> bytes;
    };
    const Anchor anchors[] = {{Tone::neutral, "vec3(0.18)", {105, 105, 105}},
                              {Tone::neutral, "vec3(0.8)", {226, 226, 226}},
                              {Tone::neutral, "vec3(1.0)", {240, 240, 240}},
                              {Tone::neutral, "vec3(4.0)", {253, 253, 253}},
                              {Tone::neutral, "vec3(4.0, 0.8, 0.4)", {253, 176, 163}},
                              {Tone::agx, "vec3(0.18)", {128, 128, 128}},
                              {Tone::agx, "vec3(0.8)", {194, 194, 194}},
                              {Tone::agx, "vec3(1.0)", {202, 202, 202}},
                              {Tone::agx, "vec3(4.0)", {239, 239, 239}},
                              {Tone::agx, "vec3(4.0, 0.8, 0.4)", {249, 203, 183}},
                              {Tone::linear, "vec3(0.214, 1.0, 4.0)", {127.5, 255, 255}}};
    for (const Anchor& anchor : anchors) {
        scene.tone = anchor.tone;
        const Shader lamp = material_of({{"color", "vec3(0.0)"},
                                         {"specular_weight", "0.0", Type::float_},
                                         {"emission", anchor.radiance}},
                                        {});
        ASSERT_TRUE(renderer->set_material(lamp, diagnostics)) << errors();
        ASSERT_TRUE(renderer->draw(scene, {}, *shown, diagnostics)) << errors();
        const std::vector<float> pixels = shown->read();
        const size_t middle = 4 * (32 * 64 + 32);
        for (size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(pixels[middle + k] * 255, anchor.bytes[k], 1.01)
                << tone_names()[static_cast<size_t>(anchor.tone)] << " " << anchor.radiance;
        EXPECT_EQ(pixels[middle + 3], 1);
        EXPECT_NEAR(pixels[0], scene.background.r, 0.5 / 255) << "no tone curve there";
    }
}

// The inverse of the Khronos PBR Neutral specification.
glm::dvec3 without_neutral(glm::dvec3 c) {
    const double start = 0.76, room = 1 - start, peak = std::max({c.r, c.g, c.b});
    if (peak > start) {
        const double before = room * room / (1 - peak) - room + start;
        const double kept = 1 / (0.15 * (before - peak) + 1);
        c = (c + (kept - 1) * peak) / kept * (before / peak);
    }
    const double least = std::min({c.r, c.g, c.b}), x = std::sqrt(least / 6.25);
    return c + (least < 0.04 ? x - least : 0.04);
}

TEST_F(ViewTest, NeutralIsUndoneByItsInverse) {
    scene.environment = 0;
    scene.tone = Tone::neutral;
    for (const glm::dvec3 radiance :
         {glm::dvec3(0.02, 0.3, 0.05), {0.5, 0.09, 0.7}, {1.5, 0.4, 0.2}, {0.9, 3, 6}}) {
        const std::string text = "vec3(" + std::to_string(radiance.r) + ", " +
                                 std::to_string(radiance.g) + ", " + std::to_string(radiance.b) +
                                 ")";
        const Shader lamp = material_of(
            {{"color", "vec3(0.0)"}, {"specular_weight", "0.0", Type::float_}, {"emission", text}},
            {});
        ASSERT_TRUE(renderer->set_material(lamp, diagnostics)) << errors();
        ASSERT_TRUE(renderer->draw(scene, {}, *target, diagnostics)) << errors();
        const std::vector<float> pixels = target->read();
        glm::dvec3 shown(0);
        for (int k = 0; k < 3; ++k) {
            const double x =
                static_cast<double>(pixels[4 * (32 * 64 + 32) + static_cast<size_t>(k)]);
            shown[k] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
        }
        const glm::dvec3 back = without_neutral(shown);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(back[k], radiance[k], 2e-3 * std::max(radiance[k], 1.0)) << text;
    }
}

TEST_F(ViewTest, ExposureMultipliesRadiance) {
    const auto shown = Target::make({size, size}, diagnostics);
    const auto drawn = [&](float exposure, float environment) {
        scene.exposure = exposure;
        scene.environment = environment;
        EXPECT_TRUE(renderer->set_material(Shader{}, diagnostics)) << errors();
        EXPECT_TRUE(renderer->draw(scene, {}, *shown, diagnostics)) << errors();
        return shown->read();
    };
    const auto brighter = drawn(2, 0.5F), same = drawn(1, 1);
    for (size_t i = 0; i < same.size(); ++i)
        ASSERT_NEAR(brighter[i], same[i], 1.01 / 255);
}

TEST_F(ViewTest, ShowsAnyOutput) {
    Shader material = material_of({{"color", "vec3(0.214, 1.0, 0.0)"},
                                   {"coat_roughness", "0.25", Type::float_},
                                   {"mask", "0.5", Type::float_}},
                                  {});
    material.reflection.outputs[0].port_type = WR_PORT_color;
    ASSERT_TRUE(renderer->set_material(material, diagnostics)) << errors();
    const auto shown = Target::make({size, size}, diagnostics);
    ViewOptions options;
    options.view = View::output;
    const std::pair<const char*, vec3> cases[] = {
        {"color", {0.5F, 1, 0}}, {"coat_roughness", vec3(0.25F)}, {"mask", vec3(0.5F)}};
    for (const auto& [output, expected] : cases) {
        options.output = output;
        ASSERT_TRUE(renderer->draw(scene, options, *shown, diagnostics)) << errors();
        const std::vector<float> pixels = shown->read();
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(pixels[4 * (32 * 64 + 32) + static_cast<size_t>(k)], expected[k],
                        1.0 / 255);
    }
    options.output = "coat";
    EXPECT_FALSE(renderer->draw(scene, options, *shown, diagnostics));
    EXPECT_TRUE(mentions(errors(), "no output 'coat'")) << errors();
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
