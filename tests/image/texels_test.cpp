// Tests of the texels that a sampler filters: decoded from sRGB before mips, or as stored.
#include "image/texels.h"

#include <cmath>

#include "image/support.h"

namespace wrinkle::test {
namespace {

// IEC 61966-2-1, written independently.
double curve(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

using Texels = ImageTest;

TEST_F(Texels, EveryStepOfIntegersIsDecodedByTheCurve) {
    for (const PixelType type : {u8, u16}) {
        const size_t steps = type == u8 ? 256 : 65536;
        Image image = make_image(static_cast<uint32_t>(steps / 16), 16, 1, type);
        for (size_t i = 0; i < steps; ++i)
            image.data[i] = static_cast<float>(i) / static_cast<float>(steps - 1);
        decode_srgb(image);
        for (size_t i = 0; i < steps; ++i)
            ASSERT_EQ(image.data[i],
                      static_cast<float>(curve(static_cast<double>(i) / double(steps - 1))))
                << i;
    }
}

TEST_F(Texels, FloatsBeyondTheRangeAreDecodedToo) {
    Image image = make_image(4, 1, 1, f32);
    image.data = {-0.01292F, 0.04045F, 2, NAN};
    decode_srgb(image);
    EXPECT_NEAR(image.data[0], -0.001, 1e-9);
    EXPECT_NEAR(image.data[1], 0.0031308, 1e-8);
    EXPECT_NEAR(image.data[2], curve(2), 1e-6);
    EXPECT_TRUE(std::isnan(image.data[3]));
}

TEST_F(Texels, AlphaIsNotDecoded) {
    struct Case {
        uint32_t channels;
        bool has_alpha;
        std::vector<float> expected;
    };
    const auto l = static_cast<float>(curve(0.5));
    for (const Case& each : {Case{1, false, {l}}, Case{2, false, {l, l}}, Case{2, true, {l, 0.5F}},
                             Case{3, false, {l, l, l}}, Case{4, true, {l, l, l, 0.5F}}}) {
        Image image = make_image(1, 1, each.channels);
        image.has_alpha = each.has_alpha;
        image.data.assign(each.channels, 0.5F);
        decode_srgb(image);
        EXPECT_EQ(image.data, each.expected) << each.channels;
    }
}

TEST_F(Texels, MipsAreMeansOfLight) {
    const fs::path file = folder / "checks.png";
    Image checks = make_image(8, 8, 3, u8);
    for (size_t i = 0; i < checks.data.size(); ++i)
        checks.data[i] = static_cast<float>((i / 3 + i / 24) % 2);
    Diagnostics problems;
    ASSERT_TRUE(save_image(checks, file, {}, problems)) << to_text(problems);
    const auto decoded = load_texels({file.string(), true}, {}, problems);
    const auto stored = load_texels({file.string(), false}, {}, problems);
    ASSERT_TRUE(decoded && stored) << to_text(problems);
    EXPECT_EQ(decoded->levels.back().data[0], 0.5F);
    EXPECT_EQ(stored->levels.back().data[0], 0.5F);
    EXPECT_EQ(decoded->levels[0].data, stored->levels[0].data) << "black and white are equal";

    for (float& value : checks.data)
        value = value > 0 ? 188.0F / 255 : 0;
    ASSERT_TRUE(save_image(checks, file, {}, problems)) << to_text(problems);
    const auto grey = load_texels({file.string(), true}, {}, problems);
    ASSERT_TRUE(grey) << to_text(problems);
    EXPECT_NEAR(grey->levels.back().data[0], curve(188.0 / 255) / 2, 1e-7);
    EXPECT_GT(std::fabs(grey->levels.back().data[0] - curve(94.0 / 255)), 0.1)
        << "decoded after the mean";
}

}  // namespace
}  // namespace wrinkle::test
