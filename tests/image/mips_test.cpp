// Tests of the mip filter that are independent of its weights: integrals over the unit square.
#include "image/mips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support.h"

namespace wrinkle {
namespace {

double mean(const Image& image, uint32_t channel) {
    double sum = 0;
    for (size_t i = channel; i < image.data.size(); i += image.channels)
        sum += image.data[i];
    return sum / (double(image.width) * image.height);
}

// The mean over [x0, x1] x [y0, y1] (in units of the image size) of an image with constant texels,
// weighted by overlap area.
double area_mean(const Image& image, double x0, double x1, double y0, double y1) {
    double sum = 0;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const double wide =
                std::min(x1, (x + 1.0) / image.width) - std::max(x0, double(x) / image.width);
            const double high =
                std::min(y1, (y + 1.0) / image.height) - std::max(y0, double(y) / image.height);
            if (wide > 0 && high > 0) sum += wide * high * *image.texel(x, y);
        }
    return sum / ((x1 - x0) * (y1 - y0));
}

constexpr std::pair<uint32_t, uint32_t> sizes[] = {{1, 1},  {2, 2},  {3, 3},   {5, 3},   {1, 7},
                                                   {16, 1}, {13, 8}, {37, 53}, {127, 64}};

TEST(Mips, LevelsHaveTheSizesOfGl) {
    const MipChain chain = build_mips(make_image(13, 5, 2));
    const std::vector<std::pair<uint32_t, uint32_t>> expected = {{13, 5}, {6, 2}, {3, 1}, {1, 1}};
    ASSERT_EQ(chain.count(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(chain.levels[i].width, expected[i].first);
        EXPECT_EQ(chain.levels[i].height, expected[i].second);
        EXPECT_EQ(chain.levels[i].channels, 2u);
    }
    EXPECT_EQ(mip_count(1024, 1), 11u);
    EXPECT_EQ(mip_count(1023, 1), 10u);
    EXPECT_EQ(mip_count(0, 4), 0u);
}

TEST(Mips, AnEmptyImageHasNone) {
    EXPECT_EQ(build_mips(Image{}).count(), 0u);
}

TEST(Mips, AConstantImageStaysConstantToTheBit) {
    for (const auto& [width, height] : sizes)
        for (const float value : {0.1f, 1.0f / 3, -7.7e10f, 3e-30f, 128 / 255.0f}) {
            Image image = make_image(width, height, 3);
            std::fill(image.data.begin(), image.data.end(), value);
            for (const Image& level : build_mips(image).levels)
                for (const float texel : level.data)
                    ASSERT_EQ(texel, value) << width << "x" << height;
        }
}

TEST(Mips, TheMeanIsKeptForEverySize) {
    for (const auto& [width, height] : sizes) {
        const Image image = test::sample_image(width, height, 4);
        for (const Image& level : build_mips(image).levels)
            for (uint32_t channel = 0; channel < 4; ++channel)
                EXPECT_NEAR(mean(level, channel), mean(image, channel), 1e-6)
                    << width << "x" << height << " at " << level.width << "x" << level.height;
    }
}

TEST(Mips, EachTexelIsTheMeanOfTheAreaItCovers) {
    for (const auto& [width, height] : sizes) {
        const Image image = test::sample_image(width, height, 1);
        const Image half = half_size(image);
        for (uint32_t y = 0; y < half.height; ++y)
            for (uint32_t x = 0; x < half.width; ++x)
                EXPECT_NEAR(*half.texel(x, y),
                            area_mean(image, double(x) / half.width, (x + 1.0) / half.width,
                                      double(y) / half.height, (y + 1.0) / half.height),
                            1e-6);
    }
}

TEST(Mips, ALinearRampStaysOne) {
    Image image = make_image(64, 32, 1);
    for (uint32_t y = 0; y < 32; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            *image.texel(x, y) = static_cast<float>(3 * (x + 0.5) / 64 - 2 * (y + 0.5) / 32);
    for (const Image& level : build_mips(image).levels)
        for (uint32_t y = 0; y < level.height; ++y)
            for (uint32_t x = 0; x < level.width; ++x)
                EXPECT_NEAR(*level.texel(x, y),
                            3 * (x + 0.5) / level.width - 2 * (y + 0.5) / level.height, 1e-6);
}

TEST(Mips, NanSpreadsOnlyToWhatItTouches) {
    Image image = test::sample_image(8, 8, 1);
    *image.texel(3, 5) = std::numeric_limits<float>::quiet_NaN();
    const Image half = half_size(image);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 4; ++x)
            EXPECT_EQ(std::isnan(*half.texel(x, y)), x == 1 && y == 2);
}

TEST(Mips, AlphaAndSourceTypeAreKept) {
    Image image = make_image(4, 4, 2, PixelType::u16);
    image.has_alpha = true;
    const MipChain chain = build_mips(image);
    EXPECT_TRUE(chain.levels.back().has_alpha);
    EXPECT_EQ(chain.levels.back().source, PixelType::u16);
}

}  // namespace
}  // namespace wrinkle
