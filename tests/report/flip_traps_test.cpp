// Inputs at which implementations of FLIP fail, and properties of its result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "report/flip.h"
#include "report/pooling.h"
#include "report/support.h"

namespace wrinkle::test {
namespace {

using namespace report;

constexpr double ppd = default_pixels_per_degree;

// A ramp of light in the upper rows, black below.
Image half_black(float scale) {
    Image image = make_image(16, 12, 3);
    for (uint32_t y = 8; y < 12; ++y)
        for (uint32_t x = 0; x < 16; ++x)
            std::fill_n(image.texel(x, y), 3, scale * static_cast<float>(x + 1));
    return image;
}

TEST(FlipTraps, AMedianOfBlackIsThatOfTheLitPixels) {
    const Image reference = half_black(1);
    const Exposures exposures = exposures_of(reference, Tone::aces);
    EXPECT_NEAR(exposures.start, std::log2(2.11887232 / 16), 1e-6);
    EXPECT_NEAR(exposures.stop, std::log2(2.11887232 / 9), 1e-6);  // the median of 1 to 16
    EXPECT_EQ(exposures.count, 2U);
    const HdrFlip result = hdr_flip(reference, half_black(1.5F), Tone::aces, exposures, ppd);
    EXPECT_GT(Pooling(result.errors).mean(), 0.01);
}

TEST(FlipTraps, ABlackReferenceHasOneExposure) {
    const Image black = filled(8, 8, {0, 0, 0}), gray = filled(8, 8, {0.5, 0.5, 0.5});
    const Exposures exposures = exposures_of(black, Tone::hable);
    EXPECT_EQ(exposures.count, 1U);
    EXPECT_EQ(exposures.at(0), 0);
    EXPECT_EQ(Pooling(hdr_flip(black, black, Tone::hable, exposures, ppd).errors).max(), 0);
    EXPECT_GT(Pooling(hdr_flip(black, gray, Tone::hable, exposures, ppd).errors).min(), 0.1);
}

TEST(FlipTraps, OneExposureIsTheFirst) {
    const Image a = filled(4, 4, {1, 1, 1}), b = filled(4, 4, {2, 2, 2});
    const HdrFlip one = hdr_flip(a, b, Tone::reinhard, {-1, 5, 1}, ppd);
    const Image expected = flip(filled(4, 4, std::vector<float>(3, 0.5F / 1.5F)),
                                filled(4, 4, std::vector<float>(3, 0.5F)), ppd);
    EXPECT_NEAR(Pooling(one.errors).max(), Pooling(expected).max(), 1e-6);
    EXPECT_EQ(Pooling(one.exposures).max(), 0);
    EXPECT_GT(Pooling(one.errors).max(), 0.05);
}

TEST(FlipTraps, ExposuresAreAtMost32) {
    Image image = filled(8, 8, {1e-30F, 1e-30F, 1e-30F});
    std::fill_n(image.texel(0, 0), 3, 1e30F);
    const Exposures exposures = exposures_of(image, Tone::aces);
    EXPECT_EQ(exposures.count, 32U);
    const HdrFlip result =
        hdr_flip(image, filled(8, 8, {1e-30F, 1e-30F, 1e-30F}), Tone::aces, exposures, ppd);
    for (const float error : result.errors.data)
        EXPECT_TRUE(error >= 0 && error <= 1) << error;
    EXPECT_GT(Pooling(result.errors).max(), 0.1);
}

TEST(FlipTraps, LightOfOneLevelHasTwoExposures) {
    EXPECT_EQ(exposures_of(filled(4, 4, {3, 3, 3}), Tone::aces).count, 2U);
}

TEST(FlipTraps, NegativeLightIsBlack) {
    const Image black = filled(4, 4, {0, 0, 0}), negative = filled(4, 4, {-5, -1e30F, -1});
    for (const Tone tone : {Tone::aces, Tone::hable, Tone::reinhard})
        EXPECT_EQ(Pooling(hdr_flip(black, negative, tone, {-4, 4, 3}, ppd).errors).max(), 0);
    EXPECT_EQ(exposures_of(negative, Tone::aces).count, 1U);
}

TEST(FlipTraps, AlphaAndMissingChannelsHaveNoEffect) {
    Image opaque = linear_image("torus_reference.png");
    Image other = linear_image("torus_warmer.png");
    const Image expected = flip(opaque, other, ppd);
    Image clear = to_rgba(other);
    for (size_t i = 3; i < clear.data.size(); i += 4)
        clear.data[i] = static_cast<float>(i % 7) / 7;
    EXPECT_EQ(flip(opaque, clear, ppd).data, expected.data);
    const Image gray = filled(3, 2, {0.25}), rgb = filled(3, 2, {0.25, 0.25, 0.25});
    EXPECT_EQ(Pooling(flip(gray, rgb, ppd)).max(), 0);
}

TEST(FlipTraps, OnePixelAndExtremeDistances) {
    const Image black = filled(1, 1, {0, 0, 0}), white = filled(1, 1, {1, 1, 1});
    for (const double distance : {min_pixels_per_degree, 10.0, max_pixels_per_degree}) {
        const float error = flip(black, white, distance).data[0];
        EXPECT_NEAR(error, 0.9673883, 5e-5) << distance;
        EXPECT_EQ(flip(white, white, distance).data[0], 0) << distance;
    }
}

// Bands of rows are filtered independently: an image higher than one band has the errors of its
// transpose.
TEST(FlipTraps, RowsAndColumnsAreTreatedAlike) {
    const Image a = linear_image("torus_reference.png"), b = linear_image("torus_noise.png");
    const auto transposed = [](const Image& image) {
        Image result = make_image(image.height, image.width, image.channels);
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < image.width; ++x)
                std::copy_n(image.texel(x, y), image.channels, result.texel(y, x));
        return result;
    };
    const Image errors = flip(a, b, ppd);
    const Image across = transposed(flip(transposed(a), transposed(b), ppd));
    for (size_t i = 0; i < errors.data.size(); ++i)
        ASSERT_NEAR(errors.data[i], across.data[i], 1e-4) << i;
}

}  // namespace
}  // namespace wrinkle::test
