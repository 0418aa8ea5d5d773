// Tests of light on a material: environments, Phong's formula, emission, opacity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "equirectangular.h"
#include "fixture.h"

namespace wrinkle::gpu {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;

class LightingTest : public WithRenderer {
protected:
    std::vector<vec3> positions() {
        const auto pixels =
            draw(material_with_normal("s.position",
                                      {{"position", Type::vec3_, SurfaceInput::position_}}),
                 View::normal);
        std::vector<vec3> result;
        for (const Pixel& pixel : pixels)
            result.push_back(pixel.value);
        return result;
    }

    // A material of constants.
    static Shader constants(const std::string& color, const std::string& roughness,
                            const std::string& metalness) {
        return material_of({{"color", color},
                            {"roughness", roughness, Type::float_},
                            {"metalness", metalness, Type::float_}},
                           {});
    }
};

TEST_F(LightingTest, AMirrorShowsTheEnvironment) {
    scene.light = 0;
    const auto places = positions();
    renderer->set_environment(equirectangular([](dvec3 d) { return vec3(d) * 0.5F + 0.5F; }, 128));
    const auto pixels = draw(constants("vec3(1.0)", "0.0", "1.0"), View::shaded);
    const vec3 eye = eye_of(scene.camera);
    size_t checked = 0;
    for (size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].covered) continue;
        const vec3 n = glm::normalize(places[i]), v = glm::normalize(eye - places[i]);
        if (glm::dot(n, v) < 0.3F) continue;
        const vec3 mirrored = 2 * glm::dot(n, v) * n - v;
        ASSERT_LT(glm::length(pixels[i].value - (mirrored * 0.5F + 0.5F)), 0.06) << i;
        ++checked;
    }
    EXPECT_GT(checked, 500U);
}

// Each pixel outside of the object shows the radiance along its ray through the view frustum.
TEST_F(LightingTest, TheEnvironmentStandsBehindTheObject) {
    const auto radiance = [](dvec3 d) { return vec3(d) * 0.3F + 0.4F; };
    renderer->set_environment(equirectangular(radiance, 256));
    const auto covered = draw(constants("vec3(1.0)", "0.5", "0.0"), View::shaded);
    scene.behind = Behind::environment;
    scene.tone = Tone::linear;
    ViewOptions sharp;
    sharp.samples = 1;
    ASSERT_TRUE(renderer->draw(scene, sharp, *target, diagnostics)) << errors();
    const std::vector<float> shown = target->read();
    const glm::dmat4 to_world =
        glm::inverse(glm::dmat4(projection_matrix(scene.camera, 1, 2)) * view_matrix(scene.camera));
    size_t checked = 0;
    for (size_t i = 0; i < covered.size(); ++i) {
        if (covered[i].covered) continue;
        const dvec2 at = (dvec2(i % size, i / size) + 0.5) / (size / 2.0) - 1.0;
        const glm::dvec4 far = to_world * glm::dvec4(at, 1, 1);
        const vec3 light = radiance(glm::normalize(dvec3(far) / far.w - eye_of(scene.camera)));
        for (int k = 0; k < 3; ++k) {
            const float srgb = 1.055F * std::pow(light[k], 1 / 2.4F) - 0.055F;
            ASSERT_NEAR(shown[4 * i + static_cast<size_t>(k)], srgb, 0.02) << i << " " << k;
        }
        ++checked;
    }
    EXPECT_GT(checked, 500U);
}

TEST_F(LightingTest, TheEnvironmentTurnsRoundTheUpAxis) {
    scene.light = 0;
    const auto look = [](dvec3 d) { return vec3(d) * 0.5F + 0.5F; };
    renderer->set_environment(equirectangular(look, 128));
    scene.environment_turn = std::numbers::pi_v<float> / 2;
    const auto turned = draw(constants("vec3(1.0)", "0.0", "1.0"), View::shaded);
    scene.environment_turn = 0;
    // Turned: the radiance of +z is now at +x, that of +x at -z.
    renderer->set_environment(equirectangular(
        [&](dvec3 d) {
            return look({-d.z, d.y, d.x});
        },
        128));
    const auto expected = draw(constants("vec3(1.0)", "0.0", "1.0"), View::shaded);
    for (size_t i = 0; i < turned.size(); ++i)
        ASSERT_LT(glm::length(turned[i].value - expected[i].value), 0.05F) << i;
    renderer->set_mood(Mood::studio);
    const auto studio = draw(constants("vec3(1.0)", "0.0", "1.0"), View::shaded);
    EXPECT_GT(glm::length(studio[32 * 64 + 32].value - expected[32 * 64 + 32].value), 0.1F);
}

TEST_F(LightingTest, AWhiteSurfaceTakesTheIrradiance) {
    scene.light = 0;
    const auto places = positions();
    renderer->set_environment(equirectangular([](dvec3 d) { return vec3(1 + d.y); }, 128));
    const auto pixels = draw(constants("vec3(1.0)", "1.0", "0.0"), View::shaded);
    for (size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].covered) continue;
        const double diffuse = 1 + 2.0 / 3 * glm::normalize(places[i]).y;
        ASSERT_GT(pixels[i].value.g, diffuse - 0.05);
        ASSERT_LT(pixels[i].value.g, diffuse + 0.15) << "a dielectric's reflection is faint";
    }
}

TEST_F(LightingTest, PhongsLightIsItsFormula) {
    const auto places = positions();
    scene.lighting = Lighting::phong;
    scene.phong = {0.1F, 0.6F, 0.5F, 8};
    scene.to_light = {2, 1, 2};
    const auto pixels = draw(constants("vec3(1.0, 0.5, 0.0)", "0.3", "1.0"), View::shaded);
    const vec3 eye = eye_of(scene.camera), light = glm::normalize(scene.to_light);
    for (size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].covered) continue;
        const vec3 n = glm::normalize(places[i]), v = glm::normalize(eye - places[i]);
        const double nl = glm::dot(n, light);
        const double rv = glm::dot(vec3(2 * glm::dot(n, light)) * n - light, v);
        const double shine = nl > 0 && rv > 0 ? 0.5 * std::pow(rv, 8) : 0;
        const double matt = 0.1 + 0.6 * std::max(nl, 0.0);
        if (std::abs(nl) < 1e-2) continue;
        ASSERT_NEAR(pixels[i].value.r, matt + shine, 2e-2) << i;
        ASSERT_NEAR(pixels[i].value.g, matt / 2 + shine, 2e-2) << i;
        ASSERT_NEAR(pixels[i].value.b, shine, 2e-2) << i;
    }
}

TEST_F(LightingTest, ChangesWithTheScene) {
    const Shader material = constants("vec3(0.5)", "0.4", "0.0");
    const auto before = draw(material, View::shaded);
    scene.lighting = Lighting::phong;
    const auto phong = draw(material, View::shaded);
    scene.lighting = Lighting::ggx;
    const auto after = draw(material, View::shaded);
    bool differs = false;
    for (size_t i = 0; i < before.size(); ++i) {
        ASSERT_EQ(before[i].value, after[i].value);
        differs = differs || before[i].value != phong[i].value;
    }
    EXPECT_TRUE(differs);
}

// Three panes, one behind the other, that emit their depth.
TEST_F(LightingTest, TransparentSurfacesAreSeenThroughEachOther) {
    Mesh panes = *make_shape("plane");
    const Mesh one = panes;
    for (const float z : {-0.5F, 0.5F}) {
        const auto first = static_cast<uint32_t>(panes.positions.size());
        for (size_t v = 0; v < one.vertex_count(); ++v) {
            panes.positions.push_back(one.positions[v] + vec3(0, 0, z));
            panes.normals.push_back(one.normals[v]);
            panes.uvs[0].push_back(one.uvs[0][v]);
        }
        for (const uint32_t index : one.indices)
            panes.indices.push_back(first + index);
    }
    renderer->set_mesh(panes);
    scene.environment = 0;
    const Shader glowing = material_of({{"color", "vec3(0.0)"},
                                        {"specular_weight", "0.0", Type::float_},
                                        {"emission", "vec3(1.0 + s.position.z)"},
                                        {"opacity", "0.25", Type::float_}},
                                       {{"position", Type::vec3_, SurfaceInput::position_}});
    ASSERT_TRUE(renderer->set_material(glowing, diagnostics)) << errors();
    ViewOptions raw;
    raw.raw = true;
    ASSERT_TRUE(renderer->draw(scene, raw, *target, diagnostics)) << errors();
    const std::vector<float> pixels = target->read();
    const size_t middle = 4 * (32 * 64 + 32);
    const double through = 0.75, expected = 0.25 * (1.5 + through * (1 + through * 0.5));
    EXPECT_NEAR(pixels[middle], expected, 1e-4);
    EXPECT_NEAR(pixels[middle + 3], 1 - through * through * through, 1e-4);
    scene.background = {1, 1, 1, 1};
    const auto shown = Target::make({size, size}, diagnostics);
    scene.tone = Tone::linear;
    scene.exposure = 1e-6F;
    ASSERT_TRUE(renderer->draw(scene, {}, *shown, diagnostics)) << errors();
    EXPECT_NEAR(shown->read()[middle], through * through * through, 1.0 / 255)
        << "the background shows through";
}

TEST_F(LightingTest, ASurfaceOfNoOpacityIsNotThere) {
    const Shader hole = material_of({{"opacity", "s.position.x > 0.0 ? 1.0 : 0.0", Type::float_}},
                                    {{"position", Type::vec3_, SurfaceInput::position_}});
    show("plane");
    const auto pixels = draw(hole, View::shaded);
    EXPECT_TRUE(pixels[32 * 64 + 40].covered);
    EXPECT_FALSE(pixels[32 * 64 + 24].covered);
}

}  // namespace
}  // namespace wrinkle::gpu
