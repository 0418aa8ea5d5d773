// Image files, read and written: PNG, JPEG, TIFF, OpenEXR, Radiance HDR; PFM and PNM are read only.
//
// The first bytes of a file decide its format, its extension does not. No colour conversion takes
// place and EXIF orientation is ignored. A file with more than four channels gives R, G, B and A if
// it begins with them and is refused otherwise; so are deep, volume and cropped-window images. Of
// several sub-images or mip levels the first is read. Integers of other widths and doubles arrive
// as float.
//
// OpenImageIO does the work in a module of its own (lib/wrinkle/wrinkle_image_oiio.so) that is
// loaded on the first call that needs it; see module.h. All functions may be called from several
// threads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "image/image.h"

namespace wrinkle {

// What a file's header may ask for; checked before any pixel is decoded.
struct ImageLimits {
    uint64_t max_side = limit_of(Limit::image_side);      // of width and of height, texels
    uint64_t max_pixels = limit_of(Limit::image_pixels);  // width * height
    uint64_t max_bytes = limit_of(Limit::image_bytes);    // width * height * channels * 4
    uint64_t left_bytes = ~uint64_t{0};  // of Limit::all_images_bytes, mips included
};

// Those of this process (base/limits.h); one that is not a number is reported.
ImageLimits image_limits_from_environment(Diagnostics& diagnostics);

struct ImageInfo {
    std::string format;  // "png", "jpeg", "tiff", "exr", "hdr", "pnm"
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t channels = 0;  // as load_image would give them
    bool has_alpha = false;
    PixelType source = PixelType::float32;
};

// What sampling it takes in memory: floats, their mips (a third more), and of bytes a packed level
// (cpu/texels.h).
uint64_t bytes_with_mips(const ImageInfo& info);
uint64_t bytes_with_mips(const Image& image);

// The header alone. Errors as load_image.
std::optional<ImageInfo> read_image_info(const std::filesystem::path& path,
                                         const ImageLimits& limits, Diagnostics& diagnostics);

// The picture, or nothing with one error that names the file and says what would help: missing,
// empty, no image, damaged, truncated, over a limit. NaN and infinite values are kept as they are
// and reported once as a warning with their count and the place of the first.
std::optional<Image> load_image(const std::filesystem::path& path, const ImageLimits& limits,
                                Diagnostics& diagnostics);
// With the limits of the environment.
std::optional<Image> load_image(const std::filesystem::path& path, Diagnostics& diagnostics);

// The same picture row by row, from the top, in memory for a few: width * channels numbers each.
// What `take` does not want to go on with ends without an error, and gives nothing.
using TakeImageRow = std::function<bool(const ImageInfo& info, const float* row)>;
std::optional<ImageInfo> read_image_rows(const std::filesystem::path& path,
                                         const ImageLimits& limits, const TakeImageRow& take,
                                         Diagnostics& diagnostics);
std::optional<ImageInfo> read_image_rows(const std::filesystem::path& path,
                                         const TakeImageRow& take, Diagnostics& diagnostics);

// A number that an ImageWriter put beside the pixels, or nothing, silently.
std::optional<float> read_image_number(const std::filesystem::path& path, const std::string& name);

struct SaveOptions {
    PixelType type = PixelType::u8;
    std::string compression = {};  // "" is the format's default; exr: none rle zip zips piz; tiff:
                                   // none lzw zip; others have none to choose
    int quality = 95;              // jpeg, 1 to 100
};

// A whole picture at once; writer.h says what each format holds and how values become integers. The
// file appears whole, by rename, or not at all; equal images give equal bytes, and a file that
// already holds them is untouched.
bool save_image(const Image& image, const std::filesystem::path& path, const SaveOptions& options,
                Diagnostics& diagnostics);

}  // namespace wrinkle
