// Image formats: detection of a file's format by its first bytes, and capabilities of each writable
// format.
//
// The detection is written by hand because OpenImageIO, which could do it, tries all of its plugins
// on an unknown file; only the few that are tested with damaged files may see one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "image/writer.h"

namespace wrinkle {

struct ImageFormat {
    std::string name;    // "png", "jpeg", "tiff", "exr", "hdr", "pnm"; "" when none is recognised
    std::string plugin;  // OpenImageIO's name
};

// Returns an empty format and the reason in `why` if the file is unreadable, empty or not an image
// of a known format.
ImageFormat sniff_format(const std::filesystem::path& path, std::string& why);

inline constexpr const char* readable_formats =
    "a PNG, JPEG, TIFF, OpenEXR, Radiance HDR, PFM or PNM file";

// Lists are words separated by spaces.
struct Writable {
    const char* extensions;
    const char* plugin;  // OpenImageIO's name
    const char* types;
    const char* channels;  // "": any number
    const char* compressions;
    const char* compression;  // the default
    bool tiles;
    bool mips;
    bool numbers;
};

const Writable* format_to_write(const std::filesystem::path& path);  // by the extension; or null

// Returns true if files of this plugin can store ImageNumbers; others need not be opened for one.
bool plugin_keeps_numbers(std::string_view plugin);

struct WriteProblem {
    std::string message;  // "" when there is none
    std::string expected;
};

// Returns the reason why a file of this format cannot be written with the options.
WriteProblem find_write_problem(const Writable* format, const WriterOptions& options);

}  // namespace wrinkle
