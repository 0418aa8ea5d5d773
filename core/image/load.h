// Reads and writes image files: PNG, JPEG, TIFF, OpenEXR, Radiance HDR; PFM and PNM are read-only.
// All but PNG need a separate module (lib/wrinkle/wrinkle_image_oiio.so) that is loaded on first
// use; see find_codec.h. All functions are thread-safe.
//
// The format is detected by the file's first bytes, not by its extension. Colors are not converted
// and EXIF orientation is ignored. The first of several sub-images or mip levels is read. Integers
// of other widths and doubles are converted to float.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "image/image.h"
#include "image/writer.h"

namespace wrinkle {

// Limits for the sizes in a file's header, checked before any pixel is decoded.
struct ImageLimits {
    uint64_t max_side = limit_of(Limit::image_side);      // width and height, in texels
    uint64_t max_pixels = limit_of(Limit::image_pixels);  // width * height
    uint64_t max_bytes = limit_of(Limit::image_bytes);    // width * height * channels * 4
    uint64_t left_bytes = ~uint64_t{0};  // rest of Limit::all_images_bytes, mips included
};

// Returns the limits of this process (base/limits.h); reports a limit that is not a number.
ImageLimits image_limits_from_environment(Diagnostics& diagnostics);

struct ImageInfo {
    std::string format;  // "png", "jpeg", "tiff", "exr", "hdr", "pnm"
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t channels = 0;  // as load_image returns them
    bool has_alpha = false;
    PixelType source = PixelType::float32;
};

// Returns the memory in bytes that sampling needs: floats, their mips (a third more) and, for u8,
// one packed level (cpu/packed_mip_chain.h).
uint64_t bytes_with_mips(const ImageInfo& info);
uint64_t bytes_with_mips(const Image& image);

// Reads only the header. Errors as load_image.
std::optional<ImageInfo> read_image_info(const std::filesystem::path& path,
                                         const ImageLimits& limits, Diagnostics& diagnostics);

// Returns the image; std::nullopt and one error that names the file and a remedy if the file is
// missing, empty, not an image, damaged, truncated or over a limit. NaN and infinite values are
// unchanged and reported once as a warning with their count and the position of the first. A file
// with more than four channels yields R, G, B and A if it begins with them and is refused
// otherwise; deep, volume and cropped-window images are refused.
std::optional<Image> load_image(const std::filesystem::path& path, const ImageLimits& limits,
                                Diagnostics& diagnostics);
// As above, with the limits of the environment.
std::optional<Image> load_image(const std::filesystem::path& path, Diagnostics& diagnostics);

// Reads the same image row by row, from the top, with only a few rows in memory: width * channels
// numbers each. If `take` returns false, reading stops without an error and returns std::nullopt.
using ImageRowSink = std::function<bool(const ImageInfo& info, const float* row)>;
std::optional<ImageInfo> read_image_rows(const std::filesystem::path& path,
                                         const ImageLimits& limits, const ImageRowSink& take,
                                         Diagnostics& diagnostics);
std::optional<ImageInfo> read_image_rows(const std::filesystem::path& path,
                                         const ImageRowSink& take, Diagnostics& diagnostics);

// Returns a number that an ImageWriter stored in the file; std::nullopt, without diagnostics, if
// there is none.
std::optional<float> read_image_number(const std::filesystem::path& path, const std::string& name);

// Writes a complete image with the type, compression and quality of `options`; writer.h documents
// the formats and the conversion to integers. The write is atomic (temporary file, rename); equal
// images give equal bytes, and a file that already holds them is not touched.
bool save_image(const Image& image, const std::filesystem::path& path, WriterOptions options,
                Diagnostics& diagnostics);

}  // namespace wrinkle
