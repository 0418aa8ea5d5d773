// Tests of textures loaded from files: read once, shared; an unreadable file is reported once and
// replaced by black.
#include "cpu/texture_store.h"

#include <gtest/gtest.h>

#include "image/load.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

class TextureStoreTest : public ::testing::Test {
protected:
    std::string picture(const char* name, float value) {
        Image image = make_image(1, 1, 1, PixelType::u8);
        image.data[0] = value;
        const auto file = folder.path() / name;
        EXPECT_TRUE(save_image(image, file, {}, problems)) << to_text(problems);
        return file.string();
    }
    float first_of(const Texture& texture) { return texture.sample_lod<float>(0.5F, 0.5F, 0)[0]; }

    TemporaryFolder folder;
    Diagnostics problems;
    TextureStore store;
};

TEST_F(TextureStoreTest, AFileIsReadOnce) {
    const TexelSource file{picture("a.png", 1)};
    const auto first = store.read(file, problems);
    ASSERT_TRUE(first) << to_text(problems);
    picture("a.png", 0);
    EXPECT_EQ(store.read(file, problems), first);
    EXPECT_EQ(store.find(file), first);
    store.forget();
    EXPECT_FALSE(store.find(file));
    const auto second = store.read(file, problems);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->levels[0].data[0], 0);
}

TEST_F(TextureStoreTest, WhatCannotBeReadIsSaidOnceAndBlack) {
    const TexelSource file{(folder.path() / "none.png").string()};
    EXPECT_FALSE(store.read(file, problems));
    EXPECT_EQ(problems.list().size(), 1U);
    EXPECT_FALSE(store.read(file, problems));
    EXPECT_EQ(problems.list().size(), 1U);
    Resource missing, there;
    missing.file = file.file;
    there.file = picture("b.png", 1);
    ASSERT_TRUE(store.read(texels_of(there), problems));
    const Resource resources[] = {there, missing, there};
    const std::vector<Texture> textures = store.textures_of(resources);
    ASSERT_EQ(textures.size(), 3U);
    EXPECT_EQ(first_of(textures[0]), 1);
    EXPECT_EQ(first_of(textures[1]), 0);
    EXPECT_EQ(first_of(textures[2]), 1);
}

TEST_F(TextureStoreTest, AFileReadAsTwoEncodingsIsTwoTextures) {
    Resource linear, srgb, by_shader;
    linear.file = srgb.file = by_shader.file = picture("a.png", 51.0F / 255);
    srgb.options.encoding = by_shader.options.encoding = Encoding::srgb;
    by_shader.options.srgb = SrgbDecoder::shader;
    const auto stored = store.read(texels_of(linear), problems);
    const auto decoded = store.read(texels_of(srgb), problems);
    ASSERT_TRUE(stored && decoded) << to_text(problems);
    EXPECT_NE(stored, decoded);
    EXPECT_EQ(store.read(texels_of(by_shader), problems), stored);
    const Resource resources[] = {linear, srgb, by_shader};
    const std::vector<Texture> textures = store.textures_of(resources);
    EXPECT_EQ(first_of(textures[0]), 0.2F);
    EXPECT_NEAR(first_of(textures[1]), 0.0331048, 1e-7);
    EXPECT_EQ(first_of(textures[2]), 0.2F);
}

}  // namespace
}  // namespace wrinkle::test
