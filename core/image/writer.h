// Writes image files in bands of rows, so that images of any size need little memory.
//
// The extension selects the format: .png (u8, u16), .jpg .jpeg (u8), .tif .tiff (u8, u16, half,
// float), .exr (half, float), .hdr (float). .tif and .exr support tiles and any number of channels,
// .exr also mips. Options that a format does not support are refused, never converted; stored.h
// defines the conversion to integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/temporary.h"
#include "image/image.h"

struct WrinkleImageCodec;
struct WrinkleImageWriter;

namespace wrinkle {

// A number stored with the pixels: in OpenEXR as an attribute, in PNG, JPEG and TIFF as
// "NAME=VALUE" in the description; not supported by Radiance HDR.
struct ImageNumber {
    std::string name;  // no spaces
    float value = 0;
};

// Name of the number that marks an image in the uv layout of a mesh, which need not be tileable.
inline constexpr const char* layout_mark = "wrinkle:layout";

struct WriterOptions {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<std::string> channels = {};  // names (.exr; its readers sort by them)
                                             // or those of channel_names()
    bool has_alpha = false;                  // the last channel
    PixelType type = PixelType::u8;
    std::string compression = {};  // "" is the format's default; exr: none rle zip zips piz; tiff:
                                   // none lzw zip; the others have no choice
    int quality = 95;              // jpeg, 1 to 100
    uint32_t tile = 0;             // side of the tiles, a multiple of 16; 0: scan lines
    bool mips = false;             // needs tiles
    std::vector<ImageNumber> numbers = {};
    uint32_t threads = 0;  // compression threads of OpenEXR; 0: one per core
};

// Returns Y, YA or RG, RGB, RGBA.
std::vector<std::string> channel_names(uint32_t channels, bool has_alpha);

// The names of OpenImageIO's `maketx --bumpslopes`.
inline constexpr std::array bumpslopes_channels = {"b0_h",     "b1_dhds",  "b2_dhdt",
                                                   "b3_dhds2", "b4_dhdt2", "b5_dh2dsdt"};

// open() creates a temporary file next to `path`. write() takes complete rows from the TOP of the
// image downwards (an Image's rows are in the opposite order), in bands of any height. With `mips`,
// each level down to 1 x 1 (sizes of mips.h) has its own rows, and levels may be interleaved: to
// compute a level from the previous one, the caller needs only one band of each in memory. finish()
// renames the temporary file to `path`; a writer destroyed before that removes it and leaves an
// existing file unchanged. A file that already holds these bytes is not touched. Equal values give
// equal bytes for any number of threads and bands of any height (if levels are interleaved, of
// equal height).
//
// A function that fails reports one error with the system's reason (disk full, missing folder);
// every later call fails silently. Not thread-safe: one thread at a time may use a writer.
class ImageWriter {
public:
    static std::optional<ImageWriter> open(const std::filesystem::path& path,
                                           const WriterOptions& options, Diagnostics& diagnostics);

    // Writes the next rows of a level: interleaved, complete rows.
    bool write(std::span<const float> rows, Diagnostics& diagnostics, uint32_t level = 0);
    // Writes rows in the file's own type, as store_values() returns them: for callers that convert
    // on several threads.
    bool write_stored(std::span<const std::byte> rows, Diagnostics& diagnostics,
                      uint32_t level = 0);

    uint32_t levels() const { return static_cast<uint32_t>(levels_.size()); }
    uint32_t width(uint32_t level = 0) const { return levels_[level].width; }
    uint32_t rows_left(uint32_t level = 0) const;  // rows not written yet

    // Precondition: all rows of all levels have been written. close() completes the temporary file;
    // finish() also closes it if necessary and renames it to `path`.
    bool close(Diagnostics& diagnostics);
    bool finish(Diagnostics& diagnostics);

private:
    struct Level {
        uint32_t width = 0, height = 0, written = 0;  // rows
        size_t row_bytes = 0;
        std::vector<std::byte> waiting = {};  // rows of an incomplete granule
    };
    struct Drop {
        const WrinkleImageCodec* codec;
        void operator()(WrinkleImageWriter* file) const;
    };

    ImageWriter(std::filesystem::path path, Temporary temporary, const WriterOptions& options,
                const WrinkleImageCodec* codec);
    bool fail(const std::string& why, Diagnostics& diagnostics);

    std::filesystem::path path_;
    Temporary temporary_;
    PixelType type_;
    uint32_t granule_;  // rows per write to the file
    std::vector<Level> levels_;
    std::vector<std::byte> converted_;  // values of one write() call
    std::unique_ptr<WrinkleImageWriter, Drop> file_;
    bool failed_ = false;
};

}  // namespace wrinkle
