// Image files written a band of rows at a time, so that a picture of any size needs little memory.
//
// open() makes a temporary file beside `path`. write() takes whole rows from the TOP of the picture
// downwards (an Image's rows run the other way) in bands of any height. With `mips` each level,
// down to 1 x 1 in the sizes of mips.h, has rows of its own, and the levels may take turns: whoever
// makes a level from the one before needs no more than a band of either in memory. finish() gives
// the file its name; a writer that goes without it leaves nothing behind, and whatever had that
// name before is as it was. A file that already holds these bytes is untouched. Equal values give
// equal bytes, in bands of any height (where levels take turns, of the same) and with any number of
// threads.
//
// Formats go by the extension: .png (u8, u16), .jpg .jpeg (u8), .tif .tiff (u8, u16, half, float),
// .exr (half, float), .hdr (float). .tif and .exr hold tiles and any number of channels, .exr mips
// as well. What a format cannot hold is refused, never converted; stored.h says how values become
// integers.
//
// Each function that fails has said so in one sentence, with the system's reason (a full disk, a
// folder that is not there), and every later one fails silently. One thread uses a writer at a
// time.
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

// Kept beside the pixels: in OpenEXR as an attribute, in PNG, JPEG and TIFF as "NAME=VALUE" in the
// description, in Radiance HDR not at all.
struct ImageNumber {
    std::string name;  // no blanks
    float value = 0;
};

// The name of the number that marks an image on the uv layout of a mesh, which need not tile.
inline constexpr const char* layout_mark = "wrinkle:layout";

struct WriterOptions {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<std::string> channels = {};  // their names (.exr; its readers sort them by these)
                                             // or those of channel_names()
    bool has_alpha = false;                  // the last channel
    PixelType type = PixelType::u8;
    std::string compression = {};  // "" is the format's default; exr: none rle zip zips piz; tiff:
                                   // none lzw zip; others have none to choose
    int quality = 95;              // jpeg, 1 to 100
    uint32_t tile = 0;             // side of the tiles, a multiple of 16; 0: scan lines
    bool mips = false;             // needs tiles
    std::vector<ImageNumber> numbers = {};
    uint32_t threads = 0;  // that compress OpenEXR; 0 is one for each core
};

// Y, YA or RG, RGB, RGBA.
std::vector<std::string> channel_names(uint32_t channels, bool has_alpha);

// Whether a file of this name keeps ImageNumbers.
bool keeps_numbers(const std::filesystem::path& path);

class ImageWriter {
public:
    static std::optional<ImageWriter> open(const std::filesystem::path& path,
                                           const WriterOptions& options, Diagnostics& diagnostics);
    ImageWriter(ImageWriter&&) noexcept;
    ImageWriter& operator=(ImageWriter&&) noexcept;
    ~ImageWriter();

    // Interleaved, the next whole rows of a level.
    bool write(std::span<const float> rows, Diagnostics& diagnostics, uint32_t level = 0);
    // The same in the file's own type, as store_values() makes them: for callers with threads.
    bool write_stored(std::span<const std::byte> rows, Diagnostics& diagnostics,
                      uint32_t level = 0);

    uint32_t levels() const;
    uint32_t width(uint32_t level = 0) const;
    uint32_t rows_left(uint32_t level = 0) const;  // that are still to come

    // All rows of all levels have been written. close() leaves nothing to be written; finish()
    // closes what is not closed yet, and gives the name.
    bool close(Diagnostics& diagnostics);
    bool finish(Diagnostics& diagnostics);

private:
    struct State;
    explicit ImageWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace wrinkle
