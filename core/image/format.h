// Which of the image formats a file holds, told by its first bytes.
#pragma once

#include <filesystem>
#include <string>

namespace wrinkle {

struct ImageFormat {
    std::string name;    // "png", "jpeg", "tiff", "exr", "hdr", "pnm"; "" when none is recognised
    std::string plugin;  // OpenImageIO's name for it
};

// An unrecognised format for an unreadable, empty or foreign file, with the reason in `why`.
ImageFormat sniff_format(const std::filesystem::path& path, std::string& why);

inline constexpr const char* readable_formats =
    "a PNG, JPEG, TIFF, OpenEXR, Radiance HDR, PFM or PNM file";

}  // namespace wrinkle
