// Tests of slopes of heights and heights of slopes, against analytic derivatives and against
// textures repeated or mirrored next to themselves.
#include <gtest/gtest.h>

#include <algorithm>

#include "image/load.h"
#include "maps/convert.h"
#include "maps/map.h"
#include "maps/poisson.h"
#include "maps/support.h"
#include "support/files.h"

namespace wrinkle::maps {
namespace {

using namespace test;

struct SlopeMap {
    std::vector<float> du, dv;
};

SlopeMap slopes_of(const Source& source) {
    const Rows rows(source);
    const size_t count = size_t{rows.width()} * rows.height();
    SlopeMap slopes{std::vector<float>(count), std::vector<float>(count)};
    for (uint32_t y = 0; y < rows.height(); ++y)
        rows.slopes(y, &slopes.du[size_t{y} * rows.width()], &slopes.dv[size_t{y} * rows.width()]);
    return slopes;
}

Source height_source(const Image& image, Wrap wrap) {
    Source source;
    source.image = &image;
    source.wrap = wrap;
    return source;
}

// Returns the largest absolute difference of two slope images.
double farthest(const std::vector<float>& a, const std::vector<float>& b) {
    double most = 0;
    for (size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(a[i]) - b[i]));
    return most;
}

// For slow waves, a filter of three texels has an error of second order in the angle per texel.
TEST(Slopes, AreTheDerivativeOfTheHeight) {
    const Waves waves{512, 256, 1};
    const Image image = height_image(waves);
    const SlopeMap slopes = slopes_of(height_source(image, Wrap::repeat));
    double steepest = 0, error = 0;
    for (uint32_t y = 0; y < waves.height; ++y)
        for (uint32_t x = 0; x < waves.width; ++x) {
            const Waves::At at = waves.at(x, y);
            const size_t i = size_t{y} * waves.width + x;
            error =
                std::max({error, std::abs(slopes.du[i] - at.du), std::abs(slopes.dv[i] - at.dv)});
            steepest = std::max({steepest, std::abs(at.du), std::abs(at.dv)});
        }
    EXPECT_LT(error, 0.01 * steepest);
    EXPECT_GT(steepest, 0.05);
}

// A plane has its slope in every texel; texels at a clamped border have half of it.
TEST(Slopes, OfAPlaneAreExactAndHalfAtTheBorderOfAClamp) {
    Image image = make_image(9, 7, 1);
    for (uint32_t y = 0; y < 7; ++y)
        for (uint32_t x = 0; x < 9; ++x)
            *image.texel(x, y) = static_cast<float>(3 * x) - static_cast<float>(y) / 4;
    Source source = height_source(image, Wrap::clamp);
    source.texel_width = 2;
    source.texel_height = 0.5f;
    const SlopeMap slopes = slopes_of(source);
    for (uint32_t y = 0; y < 7; ++y)
        for (uint32_t x = 0; x < 9; ++x) {
            EXPECT_EQ(slopes.du[y * 9 + x], x == 0 || x == 8 ? 0.75f : 1.5f);
            EXPECT_EQ(slopes.dv[y * 9 + x], y == 0 || y == 6 ? -0.25f : -0.5f);
        }
}

// The middle of nine copies has no border.
TEST(Slopes, ARepeatedPictureHasNoSeam) {
    for (const auto& [width, height] : {std::pair{13u, 9u}, {2u, 3u}, {1u, 4u}}) {
        Image one = make_image(width, height, 1), nine = make_image(3 * width, 3 * height, 1);
        for (uint32_t y = 0; y < nine.height; ++y)
            for (uint32_t x = 0; x < nine.width; ++x) {
                const uint32_t i = (y % height) * width + x % width;
                *nine.texel(x, y) = *one.texel(x % width, y % height) =
                    static_cast<float>(i * i * 7 % 31);
            }
        const SlopeMap small = slopes_of(height_source(one, Wrap::repeat));
        const SlopeMap large = slopes_of(height_source(nine, Wrap::clamp));
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x) {
                const size_t there = size_t{y + height} * nine.width + x + width;
                EXPECT_EQ(small.du[y * width + x], large.du[there]);
                EXPECT_EQ(small.dv[y * width + x], large.dv[there]);
            }
    }
}

TEST(Slopes, OfNormalsAreThoseOfTheSurface) {
    const Waves waves{64, 48, 2};
    Image image = normal_image(waves);
    Source source = height_source(image, Wrap::clamp);
    source.kind = Kind::normal;
    const SlopeMap gl = slopes_of(source);
    for (uint32_t y = 0; y < 48; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            EXPECT_NEAR(gl.du[y * 64 + x], waves.at(x, y).du, 1e-5);
            EXPECT_NEAR(gl.dv[y * 64 + x], waves.at(x, y).dv, 1e-5);
        }
    source.green = Green::dx;
    source.factor = 3;
    const SlopeMap dx = slopes_of(source);
    for (size_t i = 0; i < gl.du.size(); ++i) {
        EXPECT_FLOAT_EQ(dx.du[i], 3 * gl.du[i]);
        EXPECT_FLOAT_EQ(dx.dv[i], -3 * gl.dv[i]);
    }
}

// The clamps are those of docs/surface-gradient.md.
TEST(Slopes, OfNormalsAreClamped) {
    Image image = make_image(4, 1, 3);
    image.data = {0.5f, 0.5f, 0.5f, 1, 0.5f, 0.5f, 0, 1, 0.5f, 0.75f, 0.5f, 0.25f};
    Source source = height_source(image, Wrap::clamp);
    source.kind = Kind::normal;
    const SlopeMap slopes = slopes_of(source);
    EXPECT_EQ(slopes.du, (std::vector<float>{0, -128, 128, -1}));  // a z below 0 is negated
    EXPECT_EQ(slopes.dv[2], -128);
}

TEST(Slopes, OfTwoChannelsHaveTheirZMade) {
    Image image = make_image(2, 1, 2);
    image.data = {0.8f, 0.5f, 0.5f, 0.1f};
    Source source = height_source(image, Wrap::clamp);
    source.kind = Kind::normal;
    const SlopeMap slopes = slopes_of(source);
    EXPECT_NEAR(slopes.du[0], -0.6 / 0.8, 1e-6);
    EXPECT_NEAR(slopes.dv[1], 0.8 / 0.6, 1e-6);
}

// Covers each wrap mode, and sizes that are powers of two, odd and prime.
TEST(Height, ComesBackFromItsSlopes) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const auto& [width, height] :
             {std::pair{128u, 64u}, {61u, 37u}, {45u, 1u}, {1u, 1u}}) {
            const Waves waves{width, height, 1};
            Image image = height_image(waves);
            if (wrap == Wrap::clamp)  // adds a part that does not repeat
                for (uint32_t y = 0; y < height; ++y)
                    for (uint32_t x = 0; x < width; ++x)
                        *image.texel(x, y) += 0.02f * static_cast<float>(x + 2 * y);
            const SlopeMap slopes = slopes_of(height_source(image, wrap));
            const auto found = height_of_slopes(slopes.du, slopes.dv, width, height, wrap);
            double mean = 0;
            for (const float value : image.data)
                mean += value / static_cast<double>(image.data.size());
            for (float& value : image.data)
                value -= static_cast<float>(mean);
            EXPECT_LT(farthest(found, image.data), 0.004) << width << " x " << height;
        }
}

// A derivative map of texels with a size holds slopes per unit of length.
TEST(Height, ComesBackFromAMapOfTexelsWithASize) {
    const TemporaryFolder folder;
    Diagnostics diagnostics;
    const Image image = height_image({64, 48, 1});
    Source source = height_source(image, Wrap::repeat);
    source.texel_width = 2;
    source.texel_height = 0.5f;
    Target target;
    target.type = PixelType::float32;
    EXPECT_TRUE(convert(source, target, folder.path() / "slopes.exr", diagnostics));
    const auto slopes = load_image(folder.path() / "slopes.exr", diagnostics);
    ASSERT_TRUE(slopes) << to_text(diagnostics);
    source.image = &*slopes;
    source.kind = Kind::derivative;
    target.kind = Kind::height;
    EXPECT_TRUE(convert(source, target, folder.path() / "height.exr", diagnostics));
    const auto found = load_image(folder.path() / "height.exr", diagnostics);
    ASSERT_TRUE(found) << to_text(diagnostics);
    EXPECT_LT(farthest(found->data, image.data), 0.004);
}

// Slopes that are a pure curl have no height: the least-squares result is flat. NaN gives flat too.
TEST(Height, OfCurlAndOfNanIsFlat) {
    const uint32_t size = 32;
    std::vector<float> du(size * size), dv(size * size);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const double a = 2 * std::numbers::pi * x / size, b = 2 * std::numbers::pi * y / size;
            du[y * size + x] = static_cast<float>(std::cos(a) * std::sin(b));
            dv[y * size + x] = static_cast<float>(-std::sin(a) * std::cos(b));
        }
    for (const float value : height_of_slopes(du, dv, size, size, Wrap::repeat))
        EXPECT_NEAR(value, 0, 1e-5);
    std::vector<float> bad(size * size, NAN);
    for (const float value : height_of_slopes(bad, bad, size, size, Wrap::clamp))
        EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace wrinkle::maps
