// Tests of images written in bands: file contents as read by OpenImageIO's own tools, and no
// partial files.
#include "image/writer.h"

#include <sys/resource.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "image/formats.h"
#include "support.h"

namespace wrinkle::test {
namespace {

class Writer : public ImageTest {
protected:
    // Returns `count` different numbers, exact in u8.
    static std::vector<float> numbers(size_t count) {
        std::vector<float> values(count);
        for (size_t i = 0; i < count; ++i)
            values[i] = static_cast<float>((i * 37 + i / 251) % 256) / 255.0f;
        return values;
    }

    static WriterOptions options_for(const std::string& extension) {
        WriterOptions options;
        options.width = 150;
        options.height = 130;
        options.channels = channel_names(3, false);
        options.type = extension == ".png" || extension == ".jpg" ? u8 : f32;
        return options;
    }

    // Writes every mip level in bands of `rows` rows.
    static bool write_all(ImageWriter& writer, size_t channels, uint32_t rows,
                          Diagnostics& diagnostics) {
        for (uint32_t i = 0; i < writer.levels(); ++i) {
            const uint32_t height = writer.rows_left(i);
            const size_t row = writer.width(i) * channels;
            const std::vector<float> level = numbers(height * row);
            for (uint32_t y = 0; y < height; y += rows)
                if (!writer.write({level.data() + y * row, std::min(rows, height - y) * row},
                                  diagnostics, i))
                    return false;
        }
        return true;
    }

    std::string written(const std::string& name, const WriterOptions& options, uint32_t rows) {
        Diagnostics diagnostics;
        auto writer = ImageWriter::open(folder / name, options, diagnostics);
        EXPECT_TRUE(writer && write_all(*writer, options.channels.size(), rows, diagnostics) &&
                    writer->finish(diagnostics))
            << to_text(diagnostics);
        return diagnostics.has_errors() ? "" : bytes_of(folder / name);
    }

    Diagnostic refused(const std::string& name, const WriterOptions& options) {
        Diagnostics diagnostics;
        EXPECT_FALSE(ImageWriter::open(folder / name, options, diagnostics));
        EXPECT_TRUE(fs::is_empty(folder));
        EXPECT_EQ(diagnostics.list().size(), 1u);
        return diagnostics.list().empty() ? Diagnostic{} : diagnostics.list().front();
    }

    // Runs a shell command; returns its output.
    std::string output_of(const std::string& command) const {
        std::FILE* pipe =
            popen(("cd '" + folder.string() + "' && " + command + " 2>&1").c_str(), "r");
        std::string text;
        for (int c; pipe && (c = std::fgetc(pipe)) != EOF;)
            text += static_cast<char>(c);
        EXPECT_TRUE(pipe && pclose(pipe) == 0) << command << ": " << text;
        return text;
    }
};

WriterOptions tiled_with_mips() {
    WriterOptions options;
    options.width = 150;
    options.height = 70;
    options.channels = {"b0_h", "b1_du", "b2_dv", "b3_uu", "b4_vv", "b5_uv"};
    options.type = f32;
    options.tile = 64;
    options.mips = true;
    return options;
}

TEST_F(Writer, BandsAndThreadsDoNotShowInTheBytes) {
    for (const std::string extension : {".png", ".jpg", ".tif", ".exr", ".hdr"}) {
        const WriterOptions options = options_for(extension);
        const std::string whole = written("whole" + extension, options, options.height);
        for (const uint32_t rows : {1u, 7u, 64u, 65u, 129u})
            EXPECT_TRUE(written("bands" + extension, options, rows) == whole) << extension << rows;
    }
    for (const std::string extension : {".tif", ".exr"}) {
        WriterOptions options = tiled_with_mips();
        options.mips = extension == ".exr";
        options.threads = 1;
        const std::string whole = written("whole" + extension, options, options.height);
        for (const uint32_t threads : {1u, 2u, 7u})
            for (const uint32_t rows : {1u, 33u, 64u}) {
                options.threads = threads;
                EXPECT_TRUE(written("bands" + extension, options, rows) == whole)
                    << extension << rows;
            }
    }
}

TEST_F(Writer, TheFirstRowIsTheTopOne) {
    for (const uint32_t tile : {0u, 16u}) {
        WriterOptions options = options_for(".exr");
        options.tile = tile;
        written("a.exr", options, 20);
        const Image image = loaded(folder / "a.exr");
        const std::vector<float> all = numbers(size_t{130} * 450);
        EXPECT_EQ(image.texel(0, 129)[0], all[0]);
        EXPECT_EQ(image.texel(149, 0)[2], all.back());
        EXPECT_EQ(image.texel(77, 98)[1], all[31 * 450 + 77 * 3 + 1]);
    }
}

TEST_F(Writer, EveryLevelChannelAndNumberIsThere) {
    WriterOptions options = tiled_with_mips();
    options.numbers = {{"wrinkle:scale", 0.1f}, {"wrinkle:offset", -3}};
    written("a.exr", options, 50);
    const std::string info = output_of("iinfo -v a.exr");
    for (const std::string text : {"150 x   70, 6 channel, float", "tile size: 64 x 64",
                                   "channel list: b0_h, b1_du, b2_dv, b3_uu, b4_vv, b5_uv"})
        EXPECT_NE(info.find(text), info.npos) << info;
    EXPECT_EQ(read_image_number(folder / "a.exr", "wrinkle:scale"), 0.1f);
    EXPECT_EQ(read_image_number(folder / "a.exr", "wrinkle:offset"), -3);
    EXPECT_FALSE(read_image_number(folder / "a.exr", "scale"));
    const std::array sizes = {150u, 75u, 37u, 18u, 9u, 4u, 2u, 1u};
    for (size_t level = 0; level < sizes.size(); ++level) {
        output_of("oiiotool a.exr --selectmip " + std::to_string(level) +
                  " --ch 2,3,4,5 --chnames R,G,B,A -d float --compression none -o level.exr");
        const Image image = loaded(folder / "level.exr");
        ASSERT_EQ(image.width, sizes[level]);
        const std::vector<float> all = numbers(size_t{image.width} * image.height * 6);
        const uint32_t x = image.width / 2, y = image.height / 2;
        EXPECT_EQ(image.texel(x, image.height - 1 - y)[1], all[(y * image.width + x) * 6 + 3]);
    }
}

// Reads the files with OpenEXR's C++ library, which shares no code with the writer.
class OpenExr : public Writer {
protected:
    // Checks all six channels of all mip levels, named in the order of `channels`.
    void expect_numbers(const std::string& name, const std::vector<std::string>& channels,
                        size_t levels, float tolerance) {
        std::string command = "oiiotool";
        for (size_t level = 0; level < levels; ++level)
            for (const size_t first : {0u, 3u})
                command += " " + name + " --selectmip " + std::to_string(level) + " --ch " +
                           channels[first] + "," + channels[first + 1] + "," + channels[first + 2] +
                           " --chnames R,G,B -d float -o " + level_file(level, first);
        output_of(command);
        for (size_t level = 0; level < levels; ++level)
            for (const size_t first : {0u, 3u})
                expect_level(loaded(folder / level_file(level, first)), first, tolerance);
    }

private:
    static std::string level_file(size_t level, size_t first) {
        return std::to_string(level) + "_" + std::to_string(first) + ".tif";
    }

    static void expect_level(const Image& image, size_t first, float tolerance) {
        const std::vector<float> all = numbers(size_t{image.width} * image.height * 6);
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t i = 0; i < image.width * 3; ++i)
                ASSERT_NEAR(image.texel(0, image.height - 1 - y)[i],
                            all[(y * image.width + i / 3) * 6 + first + i % 3], tolerance)
                    << image.width << " wide, row " << y << " value " << i << " from " << first;
    }
};

TEST_F(OpenExr, EveryCompressionHoldsEveryTexelOfEveryLevel) {
    for (const PixelType type : {f32, PixelType::half})
        for (const uint32_t tile : {0u, 64u})
            for (const std::string compression : {"none", "rle", "zip", "zips", "piz"}) {
                WriterOptions options = tiled_with_mips();
                options.type = type;
                options.tile = tile;
                options.mips = tile > 0;
                options.compression = compression;
                written("a.exr", options, 64);
                const std::string info = output_of("iinfo -v a.exr");
                EXPECT_NE(info.find("compression: \"" + compression), info.npos) << info;
                expect_numbers("a.exr", options.channels, options.mips ? 8 : 1,
                               type == f32 ? 0 : 0x1p-12f);
            }
}

// Readers find every channel by its name, for any names.
TEST_F(OpenExr, NamesOfAnyLengthAndOrder) {
    WriterOptions options = tiled_with_mips();
    const std::string long_name(60, 'x');
    options.channels = {"z", "a", long_name, "B", "m", "A"};
    options.numbers = {{long_name, 7}};
    written("a.exr", options, 64);
    EXPECT_EQ(read_image_number(folder / "a.exr", long_name), 7);
    expect_numbers("a.exr", options.channels, 8, 0);
}

// Writing the mip levels by turns gives the same file as writing them one after the other.
TEST_F(OpenExr, LevelsTakeTurns) {
    const WriterOptions options = tiled_with_mips();
    Diagnostics diagnostics;
    auto writer = ImageWriter::open(folder / "a.exr", options, diagnostics);
    ASSERT_TRUE(writer);
    for (bool left = true; left;) {
        left = false;
        for (uint32_t level = 0; level < writer->levels(); ++level) {
            const size_t row = writer->width(level) * 6, done = 70 / (1u << level);
            const std::vector<float> all = numbers(std::max<size_t>(done, 1) * row);
            const uint32_t rows = std::min(writer->rows_left(level), 40u >> level | 1u);
            const float* next = all.data() + all.size() - writer->rows_left(level) * row;
            ASSERT_TRUE(writer->write({next, rows * row}, diagnostics, level));
            left |= writer->rows_left(level) > 0;
        }
    }
    ASSERT_TRUE(writer->finish(diagnostics)) << to_text(diagnostics);
    expect_numbers("a.exr", options.channels, 8, 0);
}

TEST_F(Writer, ATiffHasTilesAndAnyChannels) {
    WriterOptions options = tiled_with_mips();
    options.mips = false;
    written("a.tif", options, 50);
    const std::string info = output_of("iinfo -v a.tif");
    for (const std::string text : {"150 x   70, 6 channel, float", "tile size: 64 x 64"})
        EXPECT_NE(info.find(text), info.npos) << info;
    const Image image = loaded(folder / "a.tif");
    EXPECT_EQ(image.channels, 3u);
    EXPECT_EQ(image.texel(149, 0)[2], numbers(size_t{150} * 70 * 6)[size_t{150} * 70 * 6 - 4]);
}

TEST_F(Writer, PngJpegAndTiffKeepNumbersToo) {
    for (const std::string extension : {".png", ".jpg", ".tif"}) {
        WriterOptions options = options_for(extension);
        options.numbers = {{"wrinkle:scale", 12.5f}};
        written("a" + extension, options, 64);
        EXPECT_EQ(read_image_number(folder / ("a" + extension), "wrinkle:scale"), 12.5f);
        EXPECT_TRUE(format_to_write("a" + extension)->numbers);
    }
    EXPECT_FALSE(format_to_write("a.hdr")->numbers);
    EXPECT_FALSE(read_image_number(folder / "none.png", "wrinkle:scale"));
}

TEST_F(Writer, WhatIsNotFinishedLeavesNothingAndTheOldFile) {
    for (const std::string extension : {".png", ".jpg", ".tif", ".exr", ".hdr"}) {
        const std::string old = written("a" + extension, options_for(extension), 64);
        Diagnostics diagnostics;
        {
            auto writer =
                ImageWriter::open(folder / ("a" + extension), options_for(extension), diagnostics);
            ASSERT_TRUE(writer);
            EXPECT_TRUE(writer->write(numbers(size_t{450} * 65), diagnostics));
            EXPECT_EQ(writer->rows_left(), 65u);
        }
        EXPECT_TRUE(bytes_of(folder / ("a" + extension)) == old);
        fs::remove(folder / ("a" + extension));
        EXPECT_TRUE(fs::is_empty(folder)) << extension;
    }
}

// Simulates a full disk by the system's limit on the size of a file.
class FullDisk : public Writer {
protected:
    void SetUp() override {
        Writer::SetUp();
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
    }
    void TearDown() override {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
        Writer::TearDown();
    }
    void set_room(rlim_t bytes) const {
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }

private:
    rlimit before_ = {};
    void (*handler_)(int) = nullptr;
};

// The limit is reached at the header, within the rows, or at the last byte, which close() writes.
TEST_F(FullDisk, IsOneErrorWithItsReasonAndLeavesTheOldFile) {
    for (const std::string extension : {".png", ".jpg", ".tif", ".exr", ".hdr"}) {
        const std::string name = "a" + extension;
        const WriterOptions options = options_for(extension);
        const std::string good = written(name, options, 64);
        put(name, "old");
        for (const size_t room : {size_t{0}, size_t{10}, good.size() / 2, good.size() - 1}) {
            set_room(room);
            Diagnostics diagnostics;
            auto writer = ImageWriter::open(folder / name, options, diagnostics);
            EXPECT_FALSE(writer && write_all(*writer, 3, 64, diagnostics) &&
                         writer->finish(diagnostics));
            writer.reset();
            set_room(RLIM_INFINITY);
            ASSERT_EQ(diagnostics.list().size(), 1u) << extension << room;
            const std::string message = diagnostics.list()[0].message;
            EXPECT_NE(message.find("cannot be written: File too large"), message.npos) << message;
            EXPECT_EQ(bytes_of(folder / name), "old");
        }
        EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1) << "something is left";
        fs::remove(folder / name);
    }
}

TEST_F(FullDisk, OfTiledLevelsToo) {
    for (const std::string name : {"a.exr", "a.tif"}) {
        WriterOptions options = tiled_with_mips();
        options.mips = name == "a.exr";
        const size_t size = written(name, options, 64).size();
        fs::remove(folder / name);
        for (size_t room = 0; room < size; room += size / 9) {
            set_room(room);
            Diagnostics diagnostics;
            auto writer = ImageWriter::open(folder / name, options, diagnostics);
            EXPECT_FALSE(writer && write_all(*writer, 6, 64, diagnostics) &&
                         writer->finish(diagnostics));
            writer.reset();
            EXPECT_EQ(diagnostics.list().size(), 1u) << name << room;
            EXPECT_TRUE(fs::is_empty(folder)) << name << room;
        }
        set_room(RLIM_INFINITY);
    }
}

TEST_F(Writer, WhatAFormatCannotHoldIsRefused) {
    WriterOptions options = tiled_with_mips();
    EXPECT_EQ(refused("a.hdr", options).expected, "one of: 3");
    EXPECT_EQ(refused("a.tif", options).expected, "an .exr file");
    options.mips = false;
    options.channels = channel_names(3, false);
    EXPECT_EQ(refused("a.hdr", options).expected, "a .tif or .exr file");
    options.mips = true;
    options.tile = 20;
    EXPECT_EQ(refused("a.exr", options).expected, "a multiple of 16");
    options.tile = 0;
    EXPECT_EQ(refused("a.exr", options).expected, "tiles of 64, say");
}

TEST_F(Writer, GoesThroughALinkAndIntoAPipe) {
    const WriterOptions options = options_for(".png");
    const std::string bytes = written("real.png", options, 64);
    fs::remove(folder / "real.png");
    fs::create_symlink(folder / "real.png", folder / "link.png");
    EXPECT_TRUE(written("link.png", options, 64) == bytes);
    EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
    output_of("mkfifo pipe.png && (cat pipe.png >received 2>/dev/null &)");
    Diagnostics diagnostics;
    auto writer = ImageWriter::open(folder / "pipe.png", options, diagnostics);
    ASSERT_TRUE(writer && write_all(*writer, 3, 64, diagnostics) && writer->finish(diagnostics));
    output_of("while [ $(stat -c %s received) -lt " + std::to_string(bytes.size()) +
              " ]; do sleep 0.01; done");
    EXPECT_TRUE(bytes_of(folder / "received") == bytes);
}

}  // namespace
}  // namespace wrinkle::test
