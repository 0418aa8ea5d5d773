// Tests of the choice among the files of a folder, and of facts from their pixels.
#include "import/texture_set.h"

#include "graph/write.h"
#include "image/load.h"
#include "import/material_graph.h"
#include "maps/support.h"
#include "support/files.h"

namespace wrinkle::textures {
namespace {
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class Textures : public testing::Test {
protected:
    void save(const Image& image, const std::string& name, PixelType type = PixelType::u8) {
        WriterOptions options;
        options.type = type;
        Diagnostics failed;
        EXPECT_TRUE(save_image(image, folder.path() / name, options, failed)) << to_text(failed);
    }
    // One color.
    void put(const std::string& name, const std::vector<float>& texel = {0.5F, 0.5F, 0.5F}) {
        Image image = make_image(4, 4, static_cast<uint32_t>(texel.size()));
        for (size_t i = 0; i < image.data.size(); ++i)
            image.data[i] = texel[i % texel.size()];
        save(image, name);
    }
    void put_normal(const std::string& name, bool green_down) {
        Image image = normal_image(test::Waves{64, 64, 1});
        for (size_t i = 1; green_down && i < image.data.size(); i += 3)
            image.data[i] = 1 - image.data[i];
        save(image, name, PixelType::u16);
    }

    std::optional<TextureSet> found(const std::vector<fs::path>& inputs) {
        problems = Diagnostics();
        return find_textures(inputs, problems);
    }
    std::optional<TextureSet> found() { return found({folder.path()}); }
    std::optional<TextureSet> examined(const ExamineOptions& options = {}) {
        auto set = found();
        if (set && !examine_textures(*set, options, problems)) set.reset();
        return set;
    }
    // File that holds a channel; "" if none does.
    static std::string file_of(const TextureSet& set, Channel channel) {
        const Texture* texture = set.find(channel);
        return texture ? texture->file.filename().string() : "";
    }
    bool reports(const std::string& words) const {
        return to_text(problems).find(words) != std::string::npos;
    }

    test::TemporaryFolder folder;
    Diagnostics problems;
};

TEST_F(Textures, TheUsualNormalMapIsGreenUp) {
    for (const char* name : {"a_color.png", "a_normal_dx.png", "a_normal_gl.png"})
        put(name);
    const auto set = found();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_EQ(file_of(*set, Channel::normal), "a_normal_gl.png");
    EXPECT_TRUE(reports("a_normal_dx.png: warning: is left out: a_normal_gl.png is used"));
}

TEST_F(Textures, MapsOfTheirOwnComeBeforePackedOnesAndRoughnessBeforeGloss) {
    for (const char* name : {"a_orm.png", "a_roughness.png", "a_gloss.png", "a_bump.png"})
        put(name);
    auto set = found();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_EQ(file_of(*set, Channel::roughness), "a_roughness.png");
    EXPECT_EQ(file_of(*set, Channel::occlusion), "a_orm.png");
    EXPECT_EQ(file_of(*set, Channel::metalness), "a_orm.png");
    EXPECT_EQ(file_of(*set, Channel::height), "a_bump.png");
    EXPECT_TRUE(reports("a_gloss.png: warning: is left out: a_roughness.png is used"));
    put("a_disp.png");
    set = found();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_EQ(file_of(*set, Channel::height), "a_disp.png");
}

TEST_F(Textures, TwoFilesForOneChannelAreAnError) {
    for (const char* name : {"a_color_1k.png", "a_color_2k.png", "a_rough_1k.png"})
        put(name);
    EXPECT_FALSE(found());
    EXPECT_TRUE(
        reports("a_color_2k.png: error: is a second file for the channel color beside "
                "a_color_1k.png (name the images"));
    const auto set = found({folder.path() / "a_color_2k.png", folder.path() / "a_rough_1k.png"});
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_EQ(file_of(*set, Channel::color), "a_color_2k.png");
}

TEST_F(Textures, FilesThatAreNotRecognisedAreReported) {
    put("a_color.png");
    for (const char* name : {"b1.png", "b2.tga", "b3.png", "b4.png", "b5.png", "b6.png"})
        folder.put(name, "not opened");
    for (const char* name : {"license.txt", "a.mtlx", "a.blend"})
        folder.put(name, "no image");
    ASSERT_TRUE(found()) << to_text(problems);
    EXPECT_TRUE(reports("left out: b1.png, b2.tga, b3.png, b4.png, b5.png and 1 more (names end"));
    EXPECT_FALSE(reports("license"));
    EXPECT_EQ(problems.list().size(), 1U);
}

TEST_F(Textures, FoldersThatHoldNoSetAreErrors) {
    EXPECT_FALSE(found());
    EXPECT_TRUE(reports("holds no image (names end like"));
    folder.put("textures/a_color.png", "");
    EXPECT_FALSE(found());
    EXPECT_TRUE(reports("holds no image (name the folder with the images, such as "));
    folder.put("photo.png", "");
    EXPECT_FALSE(found());
    EXPECT_TRUE(reports("no image has a name of a channel: photo.png (names end like"));
    EXPECT_FALSE(found({folder.path() / "missing"}));
    EXPECT_TRUE(reports("missing: error: does not exist"));
    EXPECT_FALSE(found({folder.path(), folder.path() / "photo.png"}));
    EXPECT_TRUE(reports("is one folder of several inputs"));
}

TEST_F(Textures, AFolderWithManyFilesIsRefused) {
    for (size_t i = 0; i <= max_folder_files; ++i)
        folder.put("f" + std::to_string(i), "");
    EXPECT_FALSE(found());
    EXPECT_TRUE(reports("holds more than 1000 files (name the images"));
}

TEST_F(Textures, OnlyRegularFilesOfAFolderAreTaken) {
    fs::create_directory(folder.path() / "a_normal.png");
    fs::create_symlink("/dev/zero", folder.path() / "a_rough.png");
    fs::create_symlink("nowhere", folder.path() / "a_metal.png");
    put("a_color.png");
    const auto set = examined();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_EQ(file_of(*set, Channel::color), "a_color.png");
    for (const Channel channel : {Channel::normal, Channel::roughness, Channel::metalness})
        EXPECT_EQ(file_of(*set, channel), "") << name_of(channel);
}

TEST_F(Textures, TheDirectionOfGreenComesFromNamesThenFromSlopes) {
    struct Row {
        const char* name;
        bool down;  // in the image
        std::optional<maps::Green> asked;
        Encoding encoding;
        const char* report;  // "" for none
    };
    const Row rows[] = {
        {"a_normal.png", false, {}, Encoding::normal_gl, ""},
        {"a_normal.png", true, {}, Encoding::normal_dx, "is read with green down, by its slopes"},
        {"a_normal_gl.png", false, {}, Encoding::normal_gl, ""},
        {"a_normal_dx.png", true, {}, Encoding::normal_dx, ""},
        {"a_normal_gl.png",
         true,
         {},
         Encoding::normal_gl,
         "is read with green up, by its name; its slopes have green down (--green"},
        {"a_normal.png", true, maps::Green::gl, Encoding::normal_gl, ""},
        {"a_normal.png", false, maps::Green::dx, Encoding::normal_dx, ""},
    };
    for (const Row& row : rows) {
        put_normal(row.name, row.down);
        ExamineOptions options;
        options.green = row.asked;
        const auto set = examined(options);
        ASSERT_TRUE(set) << to_text(problems);
        EXPECT_EQ(set->normal_encoding, row.encoding) << row.name;
        if (*row.report)
            EXPECT_TRUE(reports(row.report)) << row.name << to_text(problems);
        else
            EXPECT_TRUE(problems.list().empty()) << row.name << to_text(problems);
        fs::remove(folder.path() / row.name);
    }
    put("a_normal.png", {0.5F, 0.5F, 1});
    ASSERT_TRUE(examined());
    EXPECT_TRUE(reports("neither its name nor its slopes state the direction"));
}

TEST_F(Textures, NormalMapsOfOtherKindsAreReported) {
    put("a_normal.png", {0.25F});
    ASSERT_TRUE(examined());
    EXPECT_TRUE(
        reports("is read as a tangent-space normal map, by its name; its values look like "
                "a height map"));
    Image two = make_image(16, 16, 2);
    for (size_t i = 0; i < two.data.size(); ++i)
        two.data[i] = 0.4F + 0.2F * static_cast<float>(i % 5) / 4;
    fs::remove(folder.path() / "a_normal.png");
    save(two, "a_normal.tif");
    const auto set = examined();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_EQ(set->normal_encoding, Encoding::normal_rg);
    ExamineOptions down;
    down.green = maps::Green::dx;
    EXPECT_FALSE(examined(down));
    EXPECT_TRUE(reports("two channels with green down"));
}

TEST_F(Textures, ImagesThatCannotBeReadAreErrorsOfTheirOwn) {
    folder.put("a_color.png", "not an image");
    folder.put("a_orm.png", "");
    EXPECT_FALSE(examined());
    EXPECT_TRUE(reports("a_color.png' is not an image"));
    EXPECT_TRUE(reports("a_orm.png' is empty"));
    EXPECT_EQ(problems.error_count(), 2U) << to_text(problems);
}

TEST_F(Textures, ChannelsThatAPackedImageLacksAreLeftOut) {
    put("a_MaskMap.png", {0.1F, 0.2F, 0.3F});
    const auto set = examined();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_TRUE(reports("has no alpha, which by its name holds the channel roughness"));
    EXPECT_EQ(file_of(*set, Channel::roughness), "");
    EXPECT_EQ(file_of(*set, Channel::metalness), "a_MaskMap.png");
    fs::remove(folder.path() / "a_MaskMap.png");
    put("a_metallicRoughness.png", {0.1F});
    EXPECT_FALSE(examined());
    EXPECT_TRUE(reports("holds none of the channels of its name"));
}

TEST_F(Textures, AnAlphaBelowOneIsTheOpacity) {
    put("a_color.png", {0.5F, 0.5F, 0.5F, 1});
    auto set = examined();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_FALSE(set->find(Channel::opacity));
    put("a_color.png", {0.5F, 0.5F, 0.5F, 0.4F});
    set = examined();
    ASSERT_TRUE(set && set->find(Channel::opacity)) << to_text(problems);
    EXPECT_EQ(set->find(Channel::opacity)->source.component, Component::alpha);
    put("a_opacity.png", {0.5F});
    set = examined();
    ASSERT_TRUE(set) << to_text(problems);
    EXPECT_EQ(file_of(*set, Channel::opacity), "a_opacity.png");
}

// Sizes: an image of 64 x 32 texels.
TEST_F(Textures, SizesComeFromTheTexelOrTheMesh) {
    save(make_image(64, 32, 1), "a_height.png");
    const auto set = examined();
    ASSERT_TRUE(set) << to_text(problems);
    struct Row {
        GraphOptions options;
        const char *tiling, *height, *scale;  // scale "" is that of the node, `surface`
    };
    const Row rows[] = {
        {{}, "[1, 1]", "0.02", "\"unit\""},
        {{.texel = {{0.01, 0.02}}}, "[1, 1]", "0.0128", ""},
        {{.texel = {{0.01, 0.01}}}, "[1, 2]", "0.0128", ""},
        {{.uv_length = 5}, "[1, 1]", "0.1", ""},
        {{.texel = {{0.01, 0.01}}, .uv_length = 6.4}, "[10, 20]", "0.0128", ""},
        {{.texel = {{0.01, 0.01}}, .height = 0.5}, "[1, 2]", "0.5", ""},
    };
    for (const Row& row : rows) {
        const Document document = material_graph(*set, row.options);
        const std::string text = canonical_text(document);
        EXPECT_NE(text.find("\"type\": \"vec2\", \"default\": " + std::string(row.tiling)),
                  text.npos)
            << text;
        EXPECT_NE(text.find("\"default\": " + std::string(row.height) + ",\n"), text.npos) << text;
        const Input* scale = document.find("height_map")->find("scale");
        EXPECT_EQ(scale != nullptr, *row.scale != '\0') << text;
    }
}

TEST_F(Textures, TheReliefOfBothMapsIsTheHeight) {
    const test::Waves waves{64, 64, 1};
    save(normal_image(waves), "a_normal.png", PixelType::u16);
    Image heights = height_image(waves);
    for (float& value : heights.data)
        value = (value + 4) / 8;
    save(heights, "a_height.png", PixelType::u16);
    const auto set = examined();
    ASSERT_TRUE(set && set->relief) << to_text(problems);
    EXPECT_NEAR(*set->relief, 8, 0.3);
    const Document document = material_graph(*set, {.texel = {{0.5, 0.5}}});
    EXPECT_NEAR(document.inputs.find("height")->default_value.as_number(), 4, 0.15);
}

}  // namespace
}  // namespace wrinkle::textures
