// Image formats: detection of a file's format by its first bytes, and capabilities of each writable
// format.
//
// OpenImageIO's own detection is not used: it tries all of its plugins on an unknown file, but only
// the plugins listed here are tested with damaged files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "image/writer.h"

namespace wrinkle {

// Returns "image 'PATH' ", which begins a message.
std::string quoted(const std::filesystem::path& path);

struct ImageFormat {
    std::string name;    // "png", "jpeg", "tiff", "exr", "hdr", "pnm"; "" when none is recognised
    std::string plugin;  // OpenImageIO's name
};

// Returns an empty format and the reason in `why` if the file is unreadable, empty or not an image
// of a known format.
ImageFormat sniff_format(const std::filesystem::path& path, std::string& why);

// Returns the bits per channel of a PNG file; 0 for another file. Reads the header only, without
// loading OpenImageIO.
int png_bits(const std::filesystem::path& path);

inline constexpr const char* readable_formats =
    "a PNG, JPEG, TIFF, OpenEXR, Radiance HDR, PFM or PNM file";

// Capabilities of a writable format. Plural strings are lists of words separated by spaces.
struct Writable {
    const char* extensions;  // lower case, with the dot
    const char* plugin;      // OpenImageIO's name
    const char* types;       // names of PixelType
    const char* channels;    // supported numbers of channels; "": any
    const char* compressions;
    const char* compression;  // the default; "": the format has only one
    bool tiles;
    bool mips;
    bool numbers;  // can store ImageNumbers as metadata
};

const Writable* format_to_write(const std::filesystem::path& path);  // by the extension; or null

// Returns true if files of this plugin can store ImageNumbers. Readers of a number skip other files
// without opening them.
bool plugin_keeps_numbers(std::string_view plugin);

struct WriteProblem {
    std::string message;  // "" when there is none
    std::string expected;
};

// Returns the reason why a file of this format cannot be written with the options.
WriteProblem find_write_problem(const Writable* format, const WriterOptions& options);

}  // namespace wrinkle
