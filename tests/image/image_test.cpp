#include "image/image.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "base/texture_options.h"

namespace wrinkle {
namespace {

using Texel = std::array<float, 4>;

TEST(Image, GrayIsRepeatedAndAlphaIsOne) {
    const float values[] = {0.2f, 0.4f, 0.6f, 0.8f};
    EXPECT_EQ(expand_texel(values, 1, false), (Texel{0.2f, 0.2f, 0.2f, 1}));
    EXPECT_EQ(expand_texel(values, 2, true), (Texel{0.2f, 0.2f, 0.2f, 0.4f}));
    EXPECT_EQ(expand_texel(values, 2, false), (Texel{0.2f, 0.4f, 0, 1}));
    EXPECT_EQ(expand_texel(values, 3, false), (Texel{0.2f, 0.4f, 0.6f, 1}));
    EXPECT_EQ(expand_texel(values, 4, true), (Texel{0.2f, 0.4f, 0.6f, 0.8f}));
}

TEST(Image, ToRgbaKeepsPlaceAndType) {
    Image image = make_image(2, 2, 1, PixelType::u8);
    image.data = {0, 0.25f, 0.5f, 1};
    const Image wide = to_rgba(image);
    EXPECT_EQ(wide.channels, 4u);
    EXPECT_EQ(wide.source, PixelType::u8);
    EXPECT_TRUE(wide.has_alpha);
    EXPECT_EQ(wide.texel(1, 0)[2], 0.25f);
    EXPECT_EQ(wide.texel(0, 1)[0], 0.5f);
    EXPECT_EQ(wide.texel(0, 1)[3], 1);
}

TEST(Image, TypesHaveNamesAndSizes) {
    EXPECT_EQ(name_of(PixelType::half), "half");
    EXPECT_EQ(name_of(PixelType::float32), "float");
    EXPECT_EQ(bytes_of(PixelType::u8), 1u);
    EXPECT_EQ(bytes_of(PixelType::half), 2u);
    EXPECT_EQ(bytes_of(PixelType::float32), 4u);
}

// The names are those of the graph format.
TEST(TextureOptions, NamesAreThoseOfTheFileFormat) {
    EXPECT_EQ(encoding_named("linear"), Encoding::linear);
    EXPECT_EQ(encoding_named("srgb"), Encoding::srgb);
    EXPECT_EQ(encoding_named("normal_gl"), Encoding::normal_gl);
    EXPECT_EQ(encoding_named("normal_dx"), Encoding::normal_dx);
    EXPECT_EQ(encoding_named("normal_rg"), Encoding::normal_rg);
    EXPECT_EQ(encoding_named("normal_ag"), Encoding::normal_ag);
    EXPECT_EQ(encoding_named("derivative"), Encoding::derivative);
    EXPECT_EQ(wrap_named("repeat"), Wrap::repeat);
    EXPECT_EQ(wrap_named("clamp"), Wrap::clamp);
    EXPECT_EQ(wrap_named("mirror"), Wrap::mirror);
    EXPECT_EQ(filter_named("linear"), Filter::linear);
    EXPECT_EQ(filter_named("nearest"), Filter::nearest);
}

TEST(TextureOptions, EveryNameComesBackAndOthersAreNone) {
    for (const std::string_view name : encoding_names)
        EXPECT_EQ(name_of(encoding_named(name).value()), name);
    for (const std::string_view name : wrap_names)
        EXPECT_EQ(name_of(wrap_named(name).value()), name);
    for (const std::string_view name : filter_names)
        EXPECT_EQ(name_of(filter_named(name).value()), name);
    EXPECT_FALSE(encoding_named("sRGB"));
    EXPECT_FALSE(encoding_named(""));
    EXPECT_FALSE(wrap_named("Repeat"));
    EXPECT_FALSE(filter_named("cubic"));
}

}  // namespace
}  // namespace wrinkle
