// Tests of files that are not images, or too large: one precise error each, no crash, and no output
// on standard error.
#include <sys/stat.h>

#include <cstdlib>

#include "image/load.h"
#include "support.h"

namespace wrinkle::test {
namespace {

class BadImage : public ImageTest {
protected:
    void SetUp() override {
        ImageTest::SetUp();
        testing::internal::CaptureStderr();
    }
    void TearDown() override {
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
        ImageTest::TearDown();
    }

    // Writes one valid file of each format.
    std::vector<fs::path> good_files() const {
        std::vector<fs::path> files;
        Diagnostics diagnostics;
        const auto save = [&](const char* name, PixelType type, const char* compression = "") {
            files.push_back(folder / name);
            EXPECT_TRUE(save_image(sample_image(24, 18, 3), files.back(),
                                   {.type = type, .compression = compression}, diagnostics));
        };
        save("a.png", PixelType::u16);
        save("a.jpg", PixelType::u8);
        save("zip.tif", PixelType::float32);
        save("none.tif", PixelType::u8, "none");
        save("zip.exr", PixelType::half);
        save("none.exr", PixelType::float32, "none");
        save("a.hdr", PixelType::float32);
        const std::vector<float> values(24 * 18 * 3, 0.5f);
        files.push_back(put(
            "a.pfm", "PF\n24 18\n-1.0\n" + std::string(reinterpret_cast<const char*>(values.data()),
                                                       values.size() * sizeof(float))));
        files.push_back(put("a.ppm", "P6\n24 18\n255\n" + std::string(24 * 18 * 3, 'x')));
        return files;
    }
};

TEST_F(BadImage, MissingFile) {
    const Diagnostic error = refusal(folder / "none.png");
    EXPECT_EQ(error.message, "image '" + (folder / "none.png").string() +
                                 "' cannot be read: No such file or directory");
}

TEST_F(BadImage, EmptyFile) {
    const Diagnostic error = refusal(put("empty.png", ""));
    EXPECT_NE(error.message.find("is empty (0 bytes)"), std::string::npos);
}

TEST_F(BadImage, Folder) {
    EXPECT_NE(refusal(folder).message.find("is a folder, not a file"), std::string::npos);
}

TEST_F(BadImage, Pipe) {
    ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
    EXPECT_NE(refusal(folder / "pipe.png").message.find("a pipe, not a file"), std::string::npos);
}

TEST_F(BadImage, ForeignContentNamesTheFormats) {
    for (const std::string_view text : {"{\"wrinkle\": 1}", "P", "P9 1 1", "BM", "\x89PNG"}) {
        const Diagnostic error = refusal(put("graph.png", text));
        EXPECT_NE(error.message.find("is not an image of a known format"), std::string::npos);
        EXPECT_EQ(error.expected, "a PNG, JPEG, TIFF, OpenEXR, Radiance HDR, PFM or PNM file");
    }
}

TEST_F(BadImage, APointerOfGitLfsIsNamed) {
    const Diagnostic error =
        refusal(put("a.png", "version https://git-lfs.github.com/spec/v1\noid sha256:1\nsize 9\n"));
    EXPECT_NE(error.message.find("is a pointer of Git LFS"), std::string::npos);
}

TEST_F(BadImage, NoPixels) {
    refusal(put("zero.png", png_file(0, 4, 8, 0, "")));
    refusal(put("zero.pfm", "Pf\n0 4\n-1.0\n"));
    refusal(put("minus.pfm", "Pf\n-4 4\n-1.0\n" + std::string(64, 'x')));
}

TEST_F(BadImage, EachLimitIsNamedWithItsRemedy) {
    const fs::path path = put("a.pfm", "Pf\n6 4\n-1.0\n" + std::string(96, '\0'));
    struct Limited {
        ImageLimits limits;
        const char* message;
        const char* remedy;
    };
    const Limited cases[] = {
        {{.max_side = 5}, "has width 6, over the limit of 5", "WRINKLE_IMAGE_MAX_SIDE=6"},
        {{.max_pixels = 23},
         "has a pixel count of 24, over the limit of 23",
         "WRINKLE_IMAGE_MAX_PIXELS=24"},
        {{.max_bytes = 95},
         "has a size in memory of 96, over the limit of 95",
         "WRINKLE_IMAGE_MAX_BYTES=96"},
    };
    for (const Limited& c : cases) {
        const Diagnostic error = refusal(path, c.limits);
        EXPECT_NE(error.message.find(c.message), std::string::npos) << error.message;
        EXPECT_NE(error.expected.find(c.remedy), std::string::npos) << error.expected;
    }
    Diagnostics diagnostics;
    EXPECT_TRUE(load_image(path, {6, 24, 96}, diagnostics)) << to_text(diagnostics);
}

TEST_F(BadImage, HugeHeadersAreRefusedBeforeDecoding) {
    EXPECT_NE(refusal(put("tall.png", png_file(3, 1000000, 8, 0, "x"))).message.find("height"),
              std::string::npos);
    EXPECT_NE(refusal(put("area.png", png_file(16384, 16384, 8, 0, "x"))).message.find("pixel"),
              std::string::npos);
    refusal(put("worst.png", png_file(0x7FFFFFFF, 0x7FFFFFFF, 16, 6, "x")));
    refusal(put("worst.pfm", "PF\n2147483647 2147483647\n-1.0\n"));
}

// The headers claim a text of 2 GB in a file of 28 bytes, and a row of 2^27 texels.
TEST_F(BadImage, SizesInAHeaderOfOpenExrAreHeldAgainstTheFileAndTheLimits) {
    const char bytes[] = "v/1\x01\x02\0\0\0tyNpe\0string\0\x0dmxxc\x8a\x96";
    const Diagnostic error = refusal(put("text.exr", std::string(bytes, sizeof bytes - 1)));
    EXPECT_NE(error.message.find("its attribute 'tyNpe' is larger than the file"),
              std::string::npos)
        << error.message;
    Diagnostics none;
    ASSERT_TRUE(
        save_image(sample_image(4, 3, 3), folder / "wide.exr", {.type = PixelType::half}, none))
        << to_text(none);
    std::string wide = bytes_of(folder / "wide.exr");
    const size_t at = wide.find("dataWindow") + sizeof "dataWindow" + sizeof "box2i" + 4;
    wide.replace(at + 8, 4, std::string("\0\0\0\x08", 4));
    const Diagnostic refused = refusal(put("wide.exr", wide));
    EXPECT_NE(refused.message.find("has width 134217729, over the limit of"), std::string::npos)
        << refused.message;
}

TEST_F(BadImage, SeveralChannelsWhoseZeroIsWhite) {
    Diagnostics none;
    ASSERT_TRUE(
        save_image(sample_image(33, 257, 4), folder / "a.tif", {.compression = "zip"}, none))
        << to_text(none);
    std::string bytes = bytes_of(folder / "a.tif");
    const size_t at = bytes.find(std::string("\x06\x01\x03\0\x01\0\0\0\x02\0", 10));
    ASSERT_NE(at, bytes.npos) << "the tag of RGB";
    bytes[at + 8] = 0;
    EXPECT_NE(refusal(put("a.tif", bytes)).message.find("white is zero"), std::string::npos);
}

TEST_F(BadImage, TheEnvironmentSetsTheLimits) {
    const fs::path path = put("a.pfm", "Pf\n6 4\n-1.0\n" + std::string(96, '\0'));
    setenv("WRINKLE_IMAGE_MAX_SIDE", "5", 1);
    Diagnostics diagnostics;
    EXPECT_FALSE(load_image(path, diagnostics));
    setenv("WRINKLE_IMAGE_MAX_SIDE", "6", 1);
    EXPECT_TRUE(load_image(path, diagnostics));
    for (const char* wrong : {"", "0", "-1", "many", "5x", "99999999999999999999"}) {
        setenv("WRINKLE_IMAGE_MAX_SIDE", wrong, 1);
        Diagnostics problems;
        EXPECT_FALSE(load_image(path, problems));
        ASSERT_EQ(problems.list().size(), 1u) << wrong;
        EXPECT_EQ(problems.list()[0].message,
                  "environment variable WRINKLE_IMAGE_MAX_SIDE is '" + std::string(wrong) + "'");
    }
    unsetenv("WRINKLE_IMAGE_MAX_SIDE");
}

// A truncated file is an error, or the complete image if only trailing bytes without texels are
// missing.
TEST_F(BadImage, TruncatedAtManyPlaces) {
    for (const fs::path& path : good_files()) {
        const std::string bytes = bytes_of(path);
        const Image whole = loaded(path);
        size_t refused = 0, tried = 0;
        for (size_t size = 0; size<bytes.size(); size += bytes.size()> 2000 ? 7 : 1, ++tried) {
            Diagnostics diagnostics;
            const auto image = load_image(put("cut", bytes.substr(0, size)), {}, diagnostics);
            EXPECT_EQ(diagnostics.error_count(), image ? 0u : 1u) << path << " cut to " << size;
            EXPECT_TRUE(!image || image->data == whole.data) << path << " cut to " << size;
            refused += image ? 0 : 1;
        }
        EXPECT_GT(refused, tried * 9 / 10) << path;
    }
}

// With any bytes changed, the result is an error or an image within the limits.
TEST_F(BadImage, DamagedBytes) {
    uint32_t state = 12345;
    const auto random = [&](size_t below) {
        state = state * 1664525 + 1013904223;
        return (state >> 8) % below;
    };
    const ImageLimits limits{512, 512 * 512, 8 << 20};
    for (const fs::path& path : good_files()) {
        const std::string bytes = bytes_of(path);
        for (int round = 0; round < 150; ++round) {
            std::string damaged = bytes;
            for (size_t i = 0; i < 1 + random(4); ++i) {
                const size_t place = random(2) ? random(damaged.size()) : random(200);
                damaged[place % damaged.size()] = static_cast<char>(random(256));
            }
            Diagnostics diagnostics;
            const auto image = load_image(put("damaged", damaged), limits, diagnostics);
            EXPECT_EQ(image.has_value(), !diagnostics.has_errors());
            EXPECT_LE(image ? image->data.size() * 4 : 0, limits.max_bytes);
        }
    }
}

TEST_F(BadImage, ErrorsAreOneLine) {
    for (const fs::path& path : good_files()) {
        const std::string bytes = bytes_of(path);
        const Diagnostic error = refusal(put("cut", bytes.substr(0, bytes.size() / 3)));
        EXPECT_EQ(error.message.find('\n'), std::string::npos);
        EXPECT_NE(error.expected, "");
    }
}

// Other code can print to standard error after an image was rejected.
TEST_F(BadImage, StandardErrorWorksAfterwards) {
    refusal(put("zero.png", png_file(0, 4, 8, 0, "")));
    std::fputs("still here", stderr);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "still here");
    testing::internal::CaptureStderr();
}

}  // namespace
}  // namespace wrinkle::test
