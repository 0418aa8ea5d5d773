// Tests of prefiltered environments, against closed forms.
#include "gpu/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "equirectangular.h"

namespace wrinkle::gpu {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;

template <typename F>
void for_each_texel(const CubeFaces& faces, F check) {
    const int side = static_cast<int>(std::lround(std::sqrt(faces[0].size())));
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < side * side; ++i)
            check(cube_direction(face, (dvec2(i % side, i / side) + 0.5) / double(side)),
                  faces[static_cast<size_t>(face)][static_cast<size_t>(i)]);
}

TEST(Environment, OfOneColourIsThatColourAtEveryRoughness) {
    const EnvironmentCube cube =
        prefilter(equirectangular([](dvec3) { return vec3(0.25F, 1, 3); }));
    for (size_t level = 0; level < environment_levels; ++level)
        for_each_texel(cube.reflections[level], [&](dvec3, vec3 texel) {
            ASSERT_LT(glm::length(texel - vec3(0.25F, 1, 3)), 1e-4) << level;
        });
    for_each_texel(cube.irradiance, [](dvec3, vec3 texel) {
        ASSERT_LT(glm::length(texel - vec3(0.25F, 1, 3)), 1e-4);
    });
}

TEST(Environment, MirrorsWhereEachDirectionIs) {
    const EnvironmentCube cube =
        prefilter(equirectangular([](dvec3 d) { return vec3(d) * 0.5F + 0.5F; }, 128));
    for_each_texel(cube.reflections[0], [](dvec3 direction, vec3 texel) {
        ASSERT_LT(glm::length(texel - (vec3(direction) * 0.5F + 0.5F)), 0.02);
    });
}

// The mean of d.y over the cosine lobe around n is 2/3 n.y.
TEST(Environment, IrradianceOfAGradientIsItsClosedForm) {
    const EnvironmentCube cube = prefilter(
        equirectangular([](dvec3 d) { return vec3(2 + 2 * d.y, 1 + d.x, 1 - d.z); }, 128));
    for_each_texel(cube.irradiance, [](dvec3 n, vec3 texel) {
        ASSERT_NEAR(texel.r, 2 + 4.0 / 3 * n.y, 0.03);
        ASSERT_NEAR(texel.g, 1 + 2.0 / 3 * n.x, 0.03);
        ASSERT_NEAR(texel.b, 1 - 2.0 / 3 * n.z, 0.03);
    });
}

TEST(Environment, RoughnessBlurs) {
    const EnvironmentCube cube =
        prefilter(equirectangular([](dvec3 d) { return vec3(d.y > 0.95 ? 50 : 0); }, 128));
    float before = 1e9F;
    for (size_t level = 0; level < environment_levels; ++level) {
        float most = 0;
        for_each_texel(cube.reflections[level], [&](dvec3, vec3 t) { most = std::max(most, t.r); });
        EXPECT_LT(most, before * 1.01F) << level;
        before = most;
    }
    EXPECT_LT(before, 10);
    EXPECT_GT(before, 1);
}

TEST(Environment, IgnoresWhatIsNoRadiance) {
    Image image = equirectangular([](dvec3) { return vec3(1); });
    image.data[0] = std::numeric_limits<float>::quiet_NaN();
    image.data[100] = -5;
    image.data[200] = std::numeric_limits<float>::infinity();
    const EnvironmentCube cube = prefilter(image);
    for (size_t level = 0; level < environment_levels; ++level)
        for_each_texel(cube.reflections[level], [](dvec3, vec3 texel) {
            ASSERT_GE(std::min({texel.r, texel.g, texel.b}), 0);
            ASSERT_LE(std::max({texel.r, texel.g, texel.b}), 1.0001F);
        });
    const Image one = make_image(1, 1, 1);
    for_each_texel(prefilter(one).reflections[3],
                   [](dvec3, vec3 texel) { ASSERT_EQ(texel, vec3(0)); });
}

}  // namespace
}  // namespace wrinkle::gpu
