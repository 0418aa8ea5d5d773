// Tests of the image reader: hand-assembled files and all output of the writer.
#include "image/load.h"

#include <atomic>
#include <cmath>
#include <cstring>
#include <thread>

#include "image/stored.h"
#include "support.h"

namespace wrinkle::test {
namespace {

using LoadTest = ImageTest;

template <typename... Values>
std::vector<float> fractions(float max, Values... values) {
    return {static_cast<float>(values) / max...};
}

TEST_F(LoadTest, TheFirstRowOfThePictureIsTheBottomOneOfTheFile) {
    const Image image =
        loaded(put("rows.png", png_file(2, 2, 8, 0, std::string("\0\x01\x02\0\xFE\xFF", 6))));
    EXPECT_EQ(image.width, 2u);
    EXPECT_EQ(image.channels, 1u);
    EXPECT_EQ(image.source, PixelType::u8);
    EXPECT_EQ(image.data, fractions(255, 254, 255, 1, 2));
}

TEST_F(LoadTest, SixteenBitsKeepEachOfTheirValues) {
    const Image image =
        loaded(put("deep.png", png_file(3, 1, 16, 0, std::string("\0\x80\x01\0\x01\xFF\xFF", 7))));
    EXPECT_EQ(image.source, PixelType::u16);
    EXPECT_EQ(image.data, fractions(65535, 0x8001, 1, 65535));
}

TEST_F(LoadTest, AlphaIsNotMultipliedIn) {
    const Image gray = loaded(put("la.png", png_file(1, 1, 8, 4, std::string("\0\xC8\x10", 3))));
    EXPECT_EQ(gray.channels, 2u);
    EXPECT_TRUE(gray.has_alpha);
    EXPECT_EQ(gray.data, fractions(255, 200, 16));
    const Image color =
        loaded(put("rgba.png", png_file(1, 1, 8, 6, std::string("\0\xC8\x64\x32\0", 5))));
    EXPECT_TRUE(color.has_alpha);
    EXPECT_EQ(color.data, fractions(255, 200, 100, 50, 0));
}

TEST_F(LoadTest, PalettesAndTransparentColorsAreExpanded) {
    const std::string colors =
        png_chunk("PLTE", std::string("\x0A\x14\x1E\x28\x32\x3C", 6)) + png_chunk("tRNS", "\x07");
    const Image palette =
        loaded(put("p.png", png_file(3, 1, 1, 3, std::string("\0\x40", 2), colors)));
    EXPECT_EQ(palette.channels, 4u);
    EXPECT_TRUE(palette.has_alpha);
    EXPECT_EQ(palette.data, fractions(255, 10, 20, 30, 7, 40, 50, 60, 255, 10, 20, 30, 7));
    const std::string black = png_chunk("tRNS", std::string(2, '\0'));
    const Image gray = loaded(put("g.png", png_file(2, 1, 4, 0, std::string("\0\x0F", 2), black)));
    EXPECT_EQ(gray.channels, 2u);
    EXPECT_EQ(gray.data, fractions(255, 0, 0, 255, 255));
}

// The passes of a square of three texels: the corner, the right corner, two of the third row, the
// middles of the first and third row, and the second row.
TEST_F(LoadTest, InterlacedRowsAreInTheirOrder) {
    const std::string passes("\0\x01\0\x03\0\x07\x09\0\x02\0\x08\0\x04\x05\x06", 15);
    const Image image = loaded(put("i.png", png_file(3, 3, 8, 0, passes, "", 1)));
    EXPECT_EQ(image.data, fractions(255, 7, 8, 9, 4, 5, 6, 1, 2, 3));
}

TEST_F(LoadTest, WhatAFileSaysOfItsColorsChangesNothing) {
    const std::string chunks = png_chunk("gAMA", big_endian(100000)) +
                               png_chunk("tEXt", std::string("Software\0none", 13));
    const std::string srgb = png_chunk("sRGB", std::string(1, '\0'));
    const std::string row("\0\x80\x40\x20", 4);
    for (const std::string& extra : {chunks, srgb})
        EXPECT_EQ(loaded(put("c.png", png_file(1, 1, 8, 2, row, extra))).data,
                  fractions(255, 128, 64, 32));
}

TEST_F(LoadTest, TheContentDecidesNotTheExtension) {
    const auto path = put("really_png.exr", png_file(1, 1, 8, 0, std::string("\0\x33", 2)));
    EXPECT_EQ(loaded(path).data, fractions(255, 0x33));
    Diagnostics diagnostics;
    EXPECT_EQ(read_image_info(path, {}, diagnostics)->format, "png");
}

TEST_F(LoadTest, PfmRowsRunUpwardsInTheFile) {
    const float rows[] = {-1.5f, 1e6f, 0.25f, 3};
    std::string bytes = "Pf\n2 2\n-1.0\n";
    bytes.append(reinterpret_cast<const char*>(rows), sizeof rows);
    const Image image = loaded(put("metres.pfm", bytes));
    EXPECT_EQ(image.source, PixelType::float32);
    EXPECT_EQ(image.data, std::vector<float>(std::begin(rows), std::end(rows)));
}

TEST_F(LoadTest, PnmIsRead) {
    EXPECT_EQ(loaded(put("a.ppm", std::string("P6\n1 2\n255\n\x01\x02\x03\xFF\xFE\xFD"))).data,
              fractions(255, 255, 254, 253, 1, 2, 3));
}

TEST_F(LoadTest, RadianceValuesAreMantissaTimesPowerOfTwo) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    bytes += std::string("\x80\x40\x20\x81\xFF\x00\x01\x80", 8);
    const Image image = loaded(put("sun.hdr", bytes));
    ASSERT_EQ(image.data.size(), 6u);
    const float expected[] = {1, 0.5f, 0.25f, 255 / 256.0f, 0, 1 / 256.0f};
    for (size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(image.data[i], expected[i], 0.5f / 128) << i;  // decoders differ by half a step
}

struct Case {
    const char* extension;
    PixelType type;
    uint32_t channels;
    bool has_alpha;
};

class RoundTrip : public ImageTest, public testing::WithParamInterface<Case> {};

TEST_P(RoundTrip, ComesBackExactly) {
    const Case& c = GetParam();
    Image image = sample_image(5, 3, c.channels);
    image.has_alpha = c.has_alpha;
    if (c.type == PixelType::half)
        for (float& value : image.data)
            value = float_from_half(half_from_float(value * 200 - 100));
    if (c.type == PixelType::float32)
        for (float& value : image.data)
            value = value * 1e20f - 3;
    folder /= "deeper";
    fs::create_directories(folder);
    const fs::path path = folder / ("picture" + std::string(c.extension));
    Diagnostics diagnostics;
    ASSERT_TRUE(save_image(image, path, {.type = c.type}, diagnostics)) << to_text(diagnostics);
    const Image back = loaded(path);
    EXPECT_EQ(back.source, c.type);
    EXPECT_EQ(back.width, 5u);
    EXPECT_EQ(back.height, 3u);
    EXPECT_EQ(back.channels, c.channels);
    EXPECT_EQ(back.has_alpha, c.has_alpha);
    EXPECT_EQ(back.data, image.data);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "a temporary file is left";
    folder = folder.parent_path();
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip,
                         testing::Values(Case{".png", u8, 1, false}, Case{".png", u8, 2, true},
                                         Case{".png", u8, 3, false}, Case{".png", u8, 4, true},
                                         Case{".PNG", u16, 1, false}, Case{".png", u16, 2, true},
                                         Case{".png", u16, 3, false}, Case{".png", u16, 4, true},
                                         Case{".tif", u8, 1, false}, Case{".tif", u8, 3, false},
                                         Case{".tiff", u16, 4, true}, Case{".tif", u16, 2, true},
                                         Case{".tif", half, 3, false}, Case{".tif", f32, 1, false},
                                         Case{".tif", f32, 4, true}, Case{".exr", half, 1, false},
                                         Case{".exr", half, 2, false}, Case{".exr", half, 3, false},
                                         Case{".exr", half, 4, true}, Case{".exr", f32, 1, false},
                                         Case{".exr", f32, 2, false}, Case{".exr", f32, 2, true},
                                         Case{".exr", f32, 3, false}, Case{".exr", f32, 4, true}),
                         [](const auto& info) {
                             const Case& c = info.param;
                             return std::string(c.extension + 1) + "_" +
                                    std::string(name_of(c.type)) + "_" +
                                    std::to_string(c.channels) + (c.has_alpha ? "a" : "");
                         });

TEST_F(LoadTest, EveryCompressionIsLossless) {
    const Image image = sample_image(40, 30, 3);
    for (const std::string file : {"none.tif", "lzw.tif", "zip.tif", "none.exr", "rle.exr",
                                   "zip.exr", "zips.exr", "piz.exr"}) {
        Diagnostics diagnostics;
        const WriterOptions options{.type = f32, .compression = fs::path(file).stem().string()};
        ASSERT_TRUE(save_image(image, folder / file, options, diagnostics)) << to_text(diagnostics);
        EXPECT_EQ(loaded(folder / file).data, image.data) << file;
    }
    EXPECT_LT(fs::file_size(folder / "zip.tif"), fs::file_size(folder / "none.tif"));
    EXPECT_LT(fs::file_size(folder / "zip.exr"), fs::file_size(folder / "none.exr"));
}

TEST_F(LoadTest, LossyFormatsComeBackNear) {
    Image image = make_image(32, 16, 3);
    for (uint32_t y = 0; y < 16; ++y)
        for (uint32_t x = 0; x < 32; ++x)
            for (uint32_t c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(0.2 + 0.02 * x + 0.01 * y * c) / 2;
    Diagnostics diagnostics;
    ASSERT_TRUE(save_image(image, folder / "a.jpg", {.type = u8}, diagnostics));
    ASSERT_TRUE(save_image(image, folder / "a.hdr", {.type = f32}, diagnostics));
    const Image jpeg = loaded(folder / "a.jpg"), hdr = loaded(folder / "a.hdr");
    EXPECT_EQ(jpeg.source, u8);
    for (size_t i = 0; i < image.data.size(); ++i) {
        EXPECT_NEAR(jpeg.data[i], image.data[i], 0.02);
        EXPECT_NEAR(hdr.data[i], image.data[i], 0.01);
    }
}

TEST_F(LoadTest, NanAndInfinityAreKeptAndReportedOnce) {
    Image image = sample_image(4, 3, 1);
    *image.texel(2, 1) = NAN;
    *image.texel(3, 2) = -INFINITY;
    Diagnostics saving, diagnostics;
    ASSERT_TRUE(save_image(image, folder / "nan.exr", {.type = f32}, saving));
    const auto back = load_image(folder / "nan.exr", diagnostics);
    ASSERT_TRUE(back);
    EXPECT_TRUE(std::isnan(*back->texel(2, 1)));
    EXPECT_EQ(*back->texel(3, 2), -INFINITY);
    ASSERT_EQ(diagnostics.list().size(), 1u);
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_NE(diagnostics.list()[0].message.find("2 values that are NaN or infinite, the first at "
                                                 "column 2, row 1 from the bottom left"),
              std::string::npos)
        << diagnostics.list()[0].message;
}

TEST_F(LoadTest, RowsAreThoseOfTheWholePictureFromTheTop) {
    Image image = sample_image(37, 150, 3);  // more rows than one band
    *image.texel(5, 70) = NAN;
    Diagnostics saving, diagnostics, whole;
    ASSERT_TRUE(save_image(image, folder / "rows.exr", {.type = f32}, saving));
    const auto back = load_image(folder / "rows.exr", whole);
    ASSERT_TRUE(back);
    uint32_t count = 0, different = 0, most = 151;
    const ImageRowSink take = [&](const ImageInfo& info, const float* row) {
        const size_t bytes = size_t{info.width} * info.channels * sizeof(float);
        different += std::memcmp(row, back->texel(0, info.height - 1 - count), bytes) != 0;
        return ++count < most;
    };
    const auto info = read_image_rows(folder / "rows.exr", take, diagnostics);
    ASSERT_TRUE(info);
    EXPECT_EQ(info->format, "exr");
    EXPECT_EQ(count, 150u);
    EXPECT_EQ(different, 0u);
    EXPECT_EQ(to_text(diagnostics), to_text(whole));
    EXPECT_NE(to_text(diagnostics).find("row 70 from the bottom"), std::string::npos);
    count = 0, most = 80;
    Diagnostics stopped;
    EXPECT_FALSE(read_image_rows(folder / "rows.exr", take, stopped));
    EXPECT_EQ(count, 80u);
    EXPECT_TRUE(stopped.list().empty());
    EXPECT_FALSE(read_image_rows(folder / "none.exr", take, stopped));
    EXPECT_EQ(stopped.error_count(), 1u);
}

TEST_F(LoadTest, SeveralThreadsMayReadAtOnce) {
    const Image image = sample_image(64, 64, 3);
    Diagnostics saving;
    ASSERT_TRUE(save_image(image, folder / "a.exr", {.type = f32}, saving));
    const fs::path bad = put("bad.png", png_file(0, 4, 8, 0, ""));
    std::atomic<int> wrong = 0;
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread)
        threads.emplace_back([&] {
            for (int round = 0; round < 10; ++round) {
                Diagnostics diagnostics;
                const auto read = load_image(folder / "a.exr", {}, diagnostics);
                wrong += !read || read->data != image.data || load_image(bad, {}, diagnostics);
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0);
}

// Real maps in ../shared/data; skipped if absent.
TEST(SharedData, TheSameTerrainInTwoFormatsIsTheSameWayUp) {
    const fs::path data = fs::path(WRINKLE_SOURCE_DIR) / "../shared/data";
    if (!fs::exists(data / "jacksboro_dem_metres.pfm")) GTEST_SKIP() << "no " << data;
    const Image metres = loaded(data / "jacksboro_dem_metres.pfm");
    const Image levels = loaded(data / "jacksboro_dem_16bit.png");
    ASSERT_EQ(metres.data.size(), levels.data.size());
    for (size_t i = 0; i < metres.data.size(); i += 97)
        EXPECT_NEAR(levels.data[i], (metres.data[i] - 236) / (1076 - 236), 2e-5) << i;
}

}  // namespace
}  // namespace wrinkle::test
