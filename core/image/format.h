// Detection of a file's image format by its first bytes.
#pragma once

#include <filesystem>
#include <string>

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

}  // namespace wrinkle
