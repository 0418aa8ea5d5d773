#include "gpu/texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixture.h"
#include "gpu/point_runner.h"

namespace wrinkle::gpu {
namespace {

using TextureTest = WithContext;

Image make_test_image(uint32_t width, uint32_t height, uint32_t channels, PixelType type) {
    Image image = make_image(width, height, channels, type);
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<float>((i * 37 + 11) % 256) / 255;
    return image;
}

// Samples a texture at points (u, v, lod).
std::vector<std::array<float, 4>> look_up(const MipChain& chain, TextureOptions options,
                                          const std::vector<float>& uv_lod,
                                          Diagnostics& diagnostics) {
    PointJob job;
    job.points = uv_lod.size() / 3;
    job.attributes = {{"p", 3, uv_lod}};
    job.globals = "uniform sampler2D picture;\n";
    job.body = "out0 = textureLod(picture, p.xy, p.z);";
    job.samplers = {sampler_info("picture", "picture.png", options)};
    job.images = {{"picture.png", &chain}};
    const auto results = run_points(job, diagnostics);
    EXPECT_TRUE(results) << to_text(diagnostics);
    return results ? results->front() : std::vector<std::array<float, 4>>(job.points);
}

void expect_every_texel(const MipChain& chain, float tolerance, Diagnostics& diagnostics) {
    std::vector<float> places;
    std::vector<std::array<float, 4>> expected;
    for (uint32_t level = 0; level < chain.count(); ++level) {
        const Image& image = chain.levels[level];
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < image.width; ++x) {
                places.push_back((static_cast<float>(x) + 0.5F) / static_cast<float>(image.width));
                places.push_back((static_cast<float>(y) + 0.5F) / static_cast<float>(image.height));
                places.push_back(static_cast<float>(level));
                expected.push_back(
                    expand_texel(image.texel(x, y), image.channels, image.has_alpha));
            }
    }
    const auto found = look_up(chain, {}, places, diagnostics);
    for (size_t i = 0; i < expected.size(); ++i)
        for (size_t c = 0; c < 4; ++c)
            ASSERT_NEAR(found[i][c], expected[i][c], tolerance) << "place " << i;
}

TEST_F(TextureTest, KeepsEveryTexelOfEveryLevel) {
    for (uint32_t channels = 1; channels <= 4; ++channels)
        for (PixelType type : {PixelType::u8, PixelType::u16, PixelType::half, PixelType::float32})
            expect_every_texel(build_mips(make_test_image(5, 3, channels, type)), 1.0F / 65535,
                               diagnostics);
}

TEST_F(TextureTest, KeepsLargeAndNegativeFloats) {
    Image image = make_image(2, 1, 1, PixelType::half);
    image.data = {-1000.25F, 60000};
    const auto found = look_up(build_mips(image), {},
                               {0.25F, 0.5F, 0, 0.75F, 0.5F, 0, 0.5F, 0.5F, 1}, diagnostics);
    EXPECT_EQ(found[0][0], -1000.25F);
    EXPECT_EQ(found[1][2], 60000);
    EXPECT_NEAR(found[2][0], 29499.875F, 0.01F);
}

TEST_F(TextureTest, InterpolatesEightBitPicturesPrecisely) {
    Image image = make_image(2, 1, 1, PixelType::u8);
    image.data = {0, 1};
    const auto found = look_up(build_mips(image), {Encoding::linear, Wrap::clamp, Filter::linear},
                               {0.3F, 0.5F, 0, 0.5F, 0.5F, 0, 0.6F, 0.5F, 0.5F}, diagnostics);
    EXPECT_NEAR(found[0][0], 0.1F, 1e-4F);
    EXPECT_NEAR(found[1][0], 0.5F, 1e-4F);
    EXPECT_NEAR(found[2][0], 0.6F, 1e-4F);  // halfway between 0.7 and the mean 0.5
}

TEST_F(TextureTest, WrapsAsItIsTold) {
    Image image = make_image(4, 1, 1);
    image.data = {10, 20, 30, 40};
    const MipChain chain = build_mips(image);
    const std::vector<float> outside{-0.125F, 0.5F, 0, 1.125F, 0.5F, 0, 1.375F, 0.5F, 0};
    struct Case {
        Wrap wrap;
        std::array<float, 3> expected;
    };
    for (const Case& c : {Case{Wrap::repeat, {40, 10, 20}}, Case{Wrap::clamp, {10, 40, 40}},
                          Case{Wrap::mirror, {10, 40, 30}}}) {
        for (Filter filter : {Filter::linear, Filter::nearest}) {
            const auto found =
                look_up(chain, {Encoding::linear, c.wrap, filter}, outside, diagnostics);
            for (size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(found[i][0], c.expected[i], 1e-4F) << name_of(c.wrap) << " " << i;
        }
    }
}

TEST_F(TextureTest, TakesTheNearestTexelWhenAsked) {
    Image image = make_image(2, 1, 1);
    image.data = {1, 2};
    const auto found = look_up(build_mips(image), {Encoding::linear, Wrap::clamp, Filter::nearest},
                               {0.49F, 0.5F, 0, 0.51F, 0.5F, 0, 0.1F, 0.5F, 0.9F}, diagnostics);
    EXPECT_EQ(found[0][0], 1);
    EXPECT_EQ(found[1][0], 2);
    EXPECT_EQ(found[2][0], 1.5F);
}

TEST_F(TextureTest, IsBlackForAnEmptyPicture) {
    const auto found = look_up(MipChain{}, {}, {0.5F, 0.5F, 0}, diagnostics);
    EXPECT_EQ(found[0], (std::array<float, 4>{0, 0, 0, 1}));
}

}  // namespace
}  // namespace wrinkle::gpu
