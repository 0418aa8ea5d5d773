// Tests of writing images: rejected options, exact bytes, and no partial files.
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include "image/load.h"
#include "support.h"

namespace wrinkle::test {
namespace {

class SaveTest : public ImageTest {
protected:
    // Returns the only error of a save that must fail and leave no file.
    Diagnostic unsaved(const Image& image, const fs::path& path, const WriterOptions& options) {
        Diagnostics diagnostics;
        EXPECT_FALSE(save_image(image, path, options, diagnostics)) << path;
        EXPECT_FALSE(fs::exists(path));
        EXPECT_TRUE(fs::is_empty(folder)) << path;
        EXPECT_EQ(diagnostics.list().size(), 1u);
        return diagnostics.list().empty() ? Diagnostic{} : diagnostics.list().front();
    }
    void save(const Image& image, const char* name, const WriterOptions& options) {
        Diagnostics diagnostics;
        EXPECT_TRUE(save_image(image, folder / name, options, diagnostics)) << to_text(diagnostics);
    }
};

TEST_F(SaveTest, WhatAFormatCannotHoldIsRefusedWithWhatItCan) {
    struct Refused {
        const char* name;
        uint32_t channels;
        PixelType type;
        const char* expected;
    };
    const Refused cases[] = {
        {"a.png", 3, f32, "one of: u8 u16"},
        {"a.png", 3, half, "one of: u8 u16"},
        {"a.jpg", 3, u16, "one of: u8"},
        {"a.jpg", 4, u8, "one of: 1 3"},
        {"a.exr", 3, u8, "one of: half float"},
        {"a.hdr", 1, f32, "one of: 3"},
        {"a.png", 2, u8, "three channels, or a .tif or .exr file"},
        {"a.bmp", 3, u8, ".png, .jpg, .tif, .exr or .hdr"},
        {"a", 3, u8, ".png, .jpg, .tif, .exr or .hdr"},
        {"png", 3, u8, ".png, .jpg, .tif, .exr or .hdr"},
    };
    for (const Refused& c : cases) {
        const Image image = sample_image(2, 2, c.channels);
        EXPECT_EQ(unsaved(image, folder / c.name, {.type = c.type}).expected, c.expected) << c.name;
    }
}

TEST_F(SaveTest, OptionsAreChecked) {
    const Image image = sample_image(2, 2, 3);
    EXPECT_EQ(unsaved(image, folder / "a.exr", {.type = half, .compression = "dwaa"}).expected,
              "one of: none rle zip zips piz");
    unsaved(image, folder / "a.png", {.type = u8, .compression = "zip"});
    unsaved(image, folder / "a.jpg", {.type = u8, .quality = 0});
    unsaved(image, folder / "a.jpg", {.type = u8, .quality = 101});
    unsaved(Image{}, folder / "a.png", {.type = u8});
}

TEST_F(SaveTest, AMissingFolderIsAnErrorWithItsReason) {
    const Diagnostic error = unsaved(sample_image(2, 2, 3), folder / "no/such/a.png", {.type = u8});
    EXPECT_NE(error.message.find("cannot be written"), std::string::npos);
    EXPECT_NE(error.message.find("No such file or directory"), std::string::npos) << error.message;
}

TEST_F(SaveTest, AFolderInTheWayIsAnErrorAndStays) {
    fs::create_directories(folder / "a.png" / "inner");
    Diagnostics diagnostics;
    EXPECT_FALSE(save_image(sample_image(2, 2, 3), folder / "a.png", {.type = u8}, diagnostics));
    EXPECT_TRUE(fs::is_directory(folder / "a.png" / "inner"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "a temporary file is left";
}

TEST_F(SaveTest, IntegersClampAndRoundToNearest) {
    Image image = make_image(8, 1, 1);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    image.data = {-0.5f, 1.5f, 10.4f / 255, 10.6f / 255, nan, infinity, -infinity, 254.4f / 255};
    save(image, "a.png", {.type = u8});
    const float expected[] = {0, 255, 10, 11, 0, 255, 0, 254};
    const Image back = loaded(folder / "a.png");
    for (size_t i = 0; i < 8; ++i)
        EXPECT_EQ(std::round(back.data[i] * 255), expected[i]) << i;
}

TEST_F(SaveTest, EverySixteenBitValueSurvives) {
    Image image = make_image(256, 256, 1);
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<float>(i) / 65535.0f;
    save(image, "a.png", {.type = u16});
    EXPECT_EQ(loaded(folder / "a.png").data, image.data);
}

TEST_F(SaveTest, EqualImagesGiveEqualBytesWithoutTimeOrPlace) {
    const Image image = sample_image(33, 21, 3);
    char year[8] = "";
    const std::time_t now = std::time(nullptr);
    std::strftime(year, sizeof year, "%Y:", std::localtime(&now));
    const std::pair<const char*, PixelType> files[] = {
        {".png", u16}, {".jpg", u8}, {".tif", f32}, {".exr", half}, {".hdr", f32}};
    for (const auto& [extension, type] : files) {
        const std::string one = "one" + std::string(extension), two = "two2" + one;
        save(image, one.c_str(), {.type = type});
        save(image, two.c_str(), {.type = type});
        const std::string bytes = bytes_of(folder / one);
        EXPECT_EQ(bytes, bytes_of(folder / two));
        EXPECT_EQ(bytes.find(year), bytes.npos) << one;
        for (const char* word : {"DateTime", "tIME", "wrinkle_image"})
            EXPECT_EQ(bytes.find(word), bytes.npos) << one << " says " << word;
    }
}

TEST_F(SaveTest, AnUnchangedFileIsLeftAlone) {
    const fs::path path = folder / "a.png";
    const Image image = sample_image(9, 9, 3);
    save(image, "a.png", {.type = u8});
    const auto past = fs::last_write_time(path) - std::chrono::hours(1);
    fs::last_write_time(path, past);
    save(image, "a.png", {.type = u8});
    EXPECT_EQ(fs::last_write_time(path), past);
    save(sample_image(9, 8, 3), "a.png", {.type = u8});
    EXPECT_NE(fs::last_write_time(path), past);
    EXPECT_EQ(loaded(path).height, 8u);
}

TEST_F(SaveTest, APngClaimsNoColorSpace) {
    save(sample_image(3, 3, 3), "a.png", {.type = u16});
    const std::string bytes = bytes_of(folder / "a.png");
    for (const char* chunk : {"gAMA", "sRGB", "iCCP", "cHRM"})
        EXPECT_EQ(bytes.find(chunk), bytes.npos) << chunk;
}

}  // namespace
}  // namespace wrinkle::test
