// Angles of normals, steps of 8 bits, pooling and color maps, against numbers worked out by hand.
#include "report/measures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/colormap.h"
#include "report/pooling.h"
#include "report/support.h"

namespace wrinkle::test {
namespace {

using namespace report;

TEST(Degrees, AreAnglesOfDecodedNormals) {
    const auto stored = [](double x, double y, double z) {
        return std::vector<float>{float((x + 1) / 2), float((y + 1) / 2), float((z + 1) / 2)};
    };
    const Image up = filled(1, 1, stored(0, 0, 1));
    EXPECT_NEAR(degrees_apart(up, filled(1, 1, stored(0.5, 0, std::sqrt(0.75)))).data[0], 30, 1e-5);
    EXPECT_NEAR(degrees_apart(up, filled(1, 1, stored(0, 0, -1))).data[0], 180, 1e-5);
    EXPECT_EQ(degrees_apart(up, up).data[0], 0);
    // The length has no effect. An angle of 0.01 degrees is below the resolution of acos in float.
    EXPECT_NEAR(degrees_apart(up, filled(1, 1, stored(0, 0, 0.25))).data[0], 0, 1e-5);
    EXPECT_NEAR(degrees_apart(up, filled(1, 1, stored(1.7453293e-4, 0, 1))).data[0], 0.01, 1e-5);
}

TEST(Degrees, AVectorOfLengthZeroIsFarFromOthers) {
    const Image zero = filled(1, 1, {0.5, 0.5, 0.5}), up = filled(1, 1, {0.5, 0.5, 1});
    EXPECT_EQ(degrees_apart(zero, up).data[0], 180);
    EXPECT_EQ(degrees_apart(up, zero).data[0], 180);
    EXPECT_EQ(degrees_apart(zero, zero).data[0], 0);
}

TEST(Degrees, TwoChannelsAreUnitNormals) {
    const Image two = image_of(1, 1, 2, {0.8F, 0.5F});  // x = 0.6, z = 0.8
    const Image three = filled(1, 1, {0.8F, 0.5F, 0.9F});
    EXPECT_NEAR(degrees_apart(two, three).data[0], 0, 1e-4);
    EXPECT_TRUE(has_normals(two));
    Image gray_alpha = two;
    gray_alpha.has_alpha = true;
    EXPECT_FALSE(has_normals(gray_alpha));
    EXPECT_FALSE(has_normals(filled(1, 1, {1})));
}

TEST(Steps, AreRootMeanSquaresOfFourChannels) {
    const Image a = image_of(2, 1, 4, {0, 0, 0, 1, 0.5, 0.5, 0.5, 1});
    const Image b = image_of(2, 1, 4, {4 / 255.0F, 0, 0, 1, 0.5, 0.5, 0.5, 0.5});
    const Image steps = steps_apart(a, b);
    EXPECT_NEAR(steps.data[0], 2, 1e-6);          // sqrt(16 / 4)
    EXPECT_NEAR(steps.data[1], 127.5 / 2, 1e-4);  // alpha counts
    EXPECT_NEAR(Pooling(steps).root_mean_square(), std::sqrt((4 + 63.75 * 63.75) / 2), 1e-4);
}

TEST(PoolingTest, OfFewValues) {
    const Pooling pooled(image_of(3, 2, 1, {0.5, 0.1F, 0, 0.4F, 0, 0.5}));
    EXPECT_NEAR(pooled.mean(), 0.25, 1e-7);
    EXPECT_EQ(pooled.min(), 0);
    EXPECT_EQ(pooled.max(), 0.5);
    EXPECT_EQ(pooled.max_x(), 2U);  // the upper row is the last one
    EXPECT_EQ(pooled.max_y(), 0U);
    EXPECT_EQ(pooled.percentile(50), 0.1F);
    EXPECT_EQ(pooled.percentile(51), 0.4F);
    EXPECT_EQ(pooled.percentile(100), 0.5F);
    EXPECT_EQ(pooled.percentile(1e-9), 0);
    EXPECT_EQ(pooled.weighted_quantile(0.25), 0.4F);  // sums: 0 0 0.1 0.5 1 1.5
    EXPECT_EQ(pooled.weighted_quantile(0.5), 0.5F);
    EXPECT_EQ(pooled.count_above(0.4F), 2U);  // above, not at
    EXPECT_EQ(pooled.count_above(0.39F), 3U);
    EXPECT_EQ(pooled.count(), 6U);
}

TEST(PoolingTest, OfZeros) {
    const Pooling pooled(filled(2, 2, {0}));
    EXPECT_EQ(pooled.mean(), 0);
    EXPECT_EQ(pooled.weighted_quantile(0.5), 0);
    EXPECT_EQ(pooled.count_above(0), 0U);
}

TEST(Colors, AreTheNearestOf256) {
    const auto color_at = [](float value, const Colormap& colors, double scale) {
        const Image image = colored(filled(1, 1, {value}), colors, scale);
        uint32_t color = 0;
        for (const float channel : image.data)
            color = color << 8 | uint32_t(std::lround(channel * 255));
        return color;
    };
    EXPECT_EQ(color_at(0, magma, 1), 0x000004U);
    EXPECT_EQ(color_at(1, magma, 1), 0xfcfdbfU);
    EXPECT_EQ(color_at(2, magma, 1), 0xfcfdbfU);
    EXPECT_EQ(color_at(1.6F / 255, magma, 1), 0x010106U);
    EXPECT_EQ(color_at(4, magma, 8), magma[128]);
    EXPECT_EQ(color_at(0, viridis, 1), 0x440154U);
    EXPECT_EQ(color_at(1, viridis, 1), 0xfde725U);
}

}  // namespace
}  // namespace wrinkle::test
