// Writes image files in bands of rows, so that images of any size need little memory.
//
// open() creates a temporary file next to `path`. write() takes complete rows from the TOP of the
// image downwards (an Image's rows are in the opposite order), in bands of any height. With `mips`,
// each level down to 1 x 1 (sizes of mips.h) has its own rows, and levels may be interleaved: to
// compute a level from the previous one, the caller needs only one band of each in memory. finish()
// renames the temporary file to `path`; a writer destroyed before that removes it and leaves an
// existing file unchanged. A file that already holds these bytes is not touched. Equal values give
// equal bytes for any number of threads and bands of any height (if levels are interleaved, of
// equal height).
//
// The extension selects the format: .png (u8, u16), .jpg .jpeg (u8), .tif .tiff (u8, u16, half,
// float), .exr (half, float), .hdr (float). .tif and .exr support tiles and any number of channels,
// .exr also mips. Options that a format does not support are refused, never converted; stored.h
// defines the conversion to integers.
//
// A function that fails reports one error with the system's reason (disk full, missing folder);
// every later call fails silently. Not thread-safe: one thread at a time may use a writer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "image/image.h"

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

class ImageWriter {
public:
    static std::optional<ImageWriter> open(const std::filesystem::path& path,
                                           const WriterOptions& options, Diagnostics& diagnostics);
    ImageWriter(ImageWriter&&) noexcept;
    ImageWriter& operator=(ImageWriter&&) noexcept;
    ~ImageWriter();

    // Writes the next rows of a level: interleaved, complete rows.
    bool write(std::span<const float> rows, Diagnostics& diagnostics, uint32_t level = 0);
    // Writes rows in the file's own type, as store_values() returns them: for callers that convert
    // on several threads.
    bool write_stored(std::span<const std::byte> rows, Diagnostics& diagnostics,
                      uint32_t level = 0);

    uint32_t levels() const;
    uint32_t width(uint32_t level = 0) const;
    uint32_t rows_left(uint32_t level = 0) const;  // rows not written yet

    // Precondition: all rows of all levels have been written. close() completes the temporary file;
    // finish() also closes it if necessary and renames it to `path`.
    bool close(Diagnostics& diagnostics);
    bool finish(Diagnostics& diagnostics);

private:
    struct State;
    explicit ImageWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace wrinkle
