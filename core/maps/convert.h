// One map made from another, and written as a file, with its mip levels.
//
// A level is the mean of what it stands for: of heights, of slopes (a normal map's levels are the
// normals of mean slopes, never means of normals), of the channels of `slopes` and `moments`.
// mips.h says which texels a mean covers.
//
// Files of integers hold t in [0, 1]. Slopes use all of it: scale is the steepest slope of the
// first level, t = (1 + slope / scale) / 2; so do heights, from the lowest, `offset`, to the
// highest, `offset` + `scale`. Both numbers go into the file as wrinkle:scale and wrinkle:offset,
// where its format keeps numbers, and come back from there when the file is read. Files of floats
// hold the values themselves. Normals are (1 + n) / 2 in every file.
#pragma once

#include <filesystem>

#include "base/diagnostics.h"
#include "image/writer.h"
#include "maps/map.h"

namespace wrinkle::maps {

inline constexpr const char* scale_name = "wrinkle:scale";
inline constexpr const char* offset_name = "wrinkle:offset";

struct Target {
    Kind kind = Kind::derivative;
    Green green = Green::gl;  // of normals
    Per per = Per::texel;     // of derivatives and slopes
    PixelType type = PixelType::half;
    std::string compression;  // "" is the format's default
    uint32_t tile = 0;        // 0: scan lines, or 64 where there are mips
    bool mips = false;
};

// Fills in what the file says of its own scale. The image belongs to that file.
void read_stored_scale(const std::filesystem::path& path, Source& source);

// From slopes to a height it solves (poisson.h). Uses all cores; equal bytes with any number.
bool convert(const Source& source, const Target& target, const std::filesystem::path& path,
             Diagnostics& diagnostics);

}  // namespace wrinkle::maps
