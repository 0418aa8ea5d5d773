// Tests of prefiltered environments, against closed forms.
#include "gpu/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "equirectangular.h"
#include "gpu/studio.h"

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

TEST(Environment, OfOneColorIsThatColorAtEveryRoughness) {
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

// The mean radiance of an image over the cosine lobe around n, texel by texel.
dvec3 cosine_mean(const Image& image, dvec3 n) {
    dvec3 sum(0);
    double weights = 0;
    for (uint32_t y = 0; y < image.height; ++y) {
        const double elevation = ((y + 0.5) / image.height - 0.5) * M_PI;
        for (uint32_t x = 0; x < image.width; ++x) {
            const double turn = ((x + 0.5) / image.width - 0.5) * 2 * M_PI;
            const dvec3 d(std::cos(elevation) * std::sin(turn), std::sin(elevation),
                          -std::cos(elevation) * std::cos(turn));
            const double weight = std::max(glm::dot(d, n), 0.0) * std::cos(elevation);
            for (int k = 0; k < 3; ++k)
                sum[k] += weight * static_cast<double>(image.texel(x, y)[k]);
            weights += weight;
        }
    }
    return sum / weights;
}

TEST(Environment, IrradianceOfTheMoodsIsTheCosineIntegral) {
    for (const Mood mood : {Mood::studio, Mood::contrast}) {
        const Image image = environment_of(mood);
        const EnvironmentCube cube = prefilter(image);
        int texels = 0;
        double off = 0;
        for_each_texel(cube.irradiance, [&](dvec3 n, vec3 texel) {
            if (texels++ % 17) return;
            const dvec3 expected = cosine_mean(image, n);
            for (int k = 0; k < 3; ++k)
                off = std::max(off, std::fabs(static_cast<double>(texel[k]) / expected[k] - 1));
        });
        EXPECT_LT(off, 0.02) << static_cast<int>(mood);
    }
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
