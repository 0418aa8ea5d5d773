// Tests of environment lighting and of the Phong formula, against closed forms.
#include "gpu/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "fixture.h"

namespace wrinkle::gpu {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;

// An image with the radiance `of(direction)` in each direction, laid out as the header documents.
template <typename F>
Image surroundings(F of, uint32_t height = 64) {
    Image image = make_image(2 * height, height, 3);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < 2 * height; ++x) {
            const double elevation = ((y + 0.5) / height - 0.5) * M_PI;
            const double turn = ((x + 0.5) / (2 * height) - 0.5) * 2 * M_PI;
            const vec3 radiance =
                of(dvec3(std::cos(elevation) * std::sin(turn), std::sin(elevation),
                         -std::cos(elevation) * std::cos(turn)));
            for (int k = 0; k < 3; ++k)
                image.texel(x, y)[k] = radiance[k];
        }
    return image;
}

template <typename F>
void for_each_texel(const EnvironmentCube& cube, size_t level, F check) {
    const int side = environment_side >> level;
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < side * side; ++i)
            check(cube_direction(face, (dvec2(i % side, i / side) + 0.5) / double(side)),
                  cube.faces[level][static_cast<size_t>(face)][static_cast<size_t>(i)]);
}

TEST(Environment, OfOneColourIsThatColourAtEveryRoughness) {
    const EnvironmentCube cube = prefilter(surroundings([](dvec3) { return vec3(0.25F, 1, 3); }));
    for (size_t level = 0; level < environment_levels; ++level)
        for_each_texel(cube, level, [&](dvec3, vec3 texel) {
            ASSERT_LT(glm::length(texel - vec3(0.25F, 1, 3)), 1e-4) << level;
        });
}

TEST(Environment, MirrorsWhereEachDirectionIs) {
    const EnvironmentCube cube =
        prefilter(surroundings([](dvec3 d) { return vec3(d) * 0.5F + 0.5F; }, 128));
    for_each_texel(cube, 0, [](dvec3 direction, vec3 texel) {
        ASSERT_LT(glm::length(texel - (vec3(direction) * 0.5F + 0.5F)), 0.02);
    });
}

// The mean of d.y over the cosine lobe around n is 2/3 n.y.
TEST(Environment, IrradianceOfAGradientIsItsClosedForm) {
    const EnvironmentCube cube =
        prefilter(surroundings([](dvec3 d) { return vec3(2 + 2 * d.y, 1 + d.x, 1 - d.z); }, 128));
    for_each_texel(cube, environment_levels - 1, [](dvec3 n, vec3 texel) {
        ASSERT_NEAR(texel.r, 2 + 4.0 / 3 * n.y, 0.03);
        ASSERT_NEAR(texel.g, 1 + 2.0 / 3 * n.x, 0.03);
        ASSERT_NEAR(texel.b, 1 - 2.0 / 3 * n.z, 0.03);
    });
}

TEST(Environment, RoughnessBlurs) {
    const EnvironmentCube cube =
        prefilter(surroundings([](dvec3 d) { return vec3(d.y > 0.95 ? 50 : 0); }, 128));
    float before = 1e9F;
    for (size_t level = 0; level < environment_levels; ++level) {
        float most = 0;
        for_each_texel(cube, level, [&](dvec3, vec3 t) { most = std::max(most, t.r); });
        EXPECT_LT(most, before * 1.01F) << level;
        before = most;
    }
    EXPECT_LT(before, 10);
    EXPECT_GT(before, 1);
}

TEST(Environment, IgnoresWhatIsNoRadiance) {
    Image image = surroundings([](dvec3) { return vec3(1); });
    image.data[0] = std::numeric_limits<float>::quiet_NaN();
    image.data[100] = -5;
    image.data[200] = std::numeric_limits<float>::infinity();
    const EnvironmentCube cube = prefilter(image);
    for (size_t level = 0; level < environment_levels; ++level)
        for_each_texel(cube, level, [](dvec3, vec3 texel) {
            ASSERT_GE(std::min({texel.r, texel.g, texel.b}), 0);
            ASSERT_LE(std::max({texel.r, texel.g, texel.b}), 1.0001F);
        });
    const Image one = make_image(1, 1, 1);
    for_each_texel(prefilter(one), 3, [](dvec3, vec3 texel) { ASSERT_EQ(texel, vec3(0)); });
}

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

TEST_F(LightingTest, AMirrorShowsTheSurroundings) {
    scene.light = 0;
    const auto places = positions();
    renderer->set_environment(surroundings([](dvec3 d) { return vec3(d) * 0.5F + 0.5F; }, 128));
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
TEST_F(LightingTest, TheSurroundingsStandBehindTheObject) {
    const auto radiance = [](dvec3 d) { return vec3(d) * 0.3F + 0.4F; };
    renderer->set_environment(surroundings(radiance, 256));
    const auto covered = draw(constants("vec3(1.0)", "0.5", "0.0"), View::shaded);
    scene.surroundings = true;
    ASSERT_TRUE(renderer->draw(scene, {}, *target, diagnostics)) << errors();
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

TEST_F(LightingTest, SurroundingsTurnRoundTheUpAxis) {
    scene.light = 0;
    const auto look = [](dvec3 d) { return vec3(d) * 0.5F + 0.5F; };
    renderer->set_environment(surroundings(look, 128));
    scene.environment_turn = std::numbers::pi_v<float> / 2;
    const auto turned = draw(constants("vec3(1.0)", "0.0", "1.0"), View::shaded);
    scene.environment_turn = 0;
    // Turned: the radiance of +z is now at +x, that of +x at -z.
    renderer->set_environment(surroundings([&](dvec3 d) { return look({-d.z, d.y, d.x}); }, 128));
    const auto expected = draw(constants("vec3(1.0)", "0.0", "1.0"), View::shaded);
    for (size_t i = 0; i < turned.size(); ++i)
        ASSERT_LT(glm::length(turned[i].value - expected[i].value), 0.05F) << i;
    renderer->forget_environment();
    const auto sky = draw(constants("vec3(1.0)", "0.0", "1.0"), View::shaded);
    EXPECT_GT(glm::length(sky[32 * 64 + 32].value - expected[32 * 64 + 32].value), 0.1F);
}

TEST_F(LightingTest, AWhiteSurfaceTakesTheIrradiance) {
    scene.light = 0;
    const auto places = positions();
    renderer->set_environment(surroundings([](dvec3 d) { return vec3(1 + d.y); }, 128));
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
    renderer->set_lighting(Lighting::phong);
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

TEST_F(LightingTest, ChangesWithTheNextMaterial) {
    const Shader material = constants("vec3(0.5)", "0.4", "0.0");
    const auto before = draw(material, View::shaded);
    renderer->set_lighting(Lighting::phong);
    const auto phong = draw(material, View::shaded);
    renderer->set_lighting(Lighting::ggx);
    const auto after = draw(material, View::shaded);
    bool differs = false;
    for (size_t i = 0; i < before.size(); ++i) {
        ASSERT_EQ(before[i].value, after[i].value);
        differs = differs || before[i].value != phong[i].value;
    }
    EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace wrinkle::gpu
