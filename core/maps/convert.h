// Converts one map to another and writes it to a file, optionally with mip levels.
//
// A mip level is the mean of the texels that it covers: of heights, of slopes (a normal map's
// levels are the normals of mean slopes, not means of normals), of the channels of `slopes` and
// `moments`. image/mips.h defines the texels of each mean.
#pragma once

#include <filesystem>

#include "base/diagnostics.h"
#include "image/writer.h"
#include "maps/map.h"

namespace wrinkle::maps {

// Integer files hold t in [0, 1]. Slopes use the full range: scale is the steepest slope of
// level 0, t = (1 + slope / scale) / 2. Heights range from the lowest, `offset`, to the highest,
// `offset` + `scale`. Both numbers are stored in the file as wrinkle:scale and wrinkle:offset, if
// its format has metadata, and are applied when it is read. Float files hold the values themselves.
// Normals are (1 + n) / 2 in every file.
inline constexpr const char* scale_name = "wrinkle:scale";
inline constexpr const char* offset_name = "wrinkle:offset";

struct Target {
    Kind kind = Kind::derivative;
    Green green = Green::gl;  // only for normals
    Per per = Per::texel;     // only for derivatives and slopes
    PixelType type = PixelType::half;
    std::string compression;  // "": the format's default
    uint32_t tile = 0;        // 0: scan lines, or 64 with mips
    bool mips = false;
};

// Reads the scale and offset stored in the file at `path`, from which the image was loaded.
void read_stored_scale(const std::filesystem::path& path, Source& source);

// Converts slopes to a height by least squares (poisson.h). Uses all cores; the output bytes do not
// depend on their number. Returns false and appends diagnostics on failure.
bool convert(const Source& source, const Target& target, const std::filesystem::path& path,
             Diagnostics& diagnostics);

}  // namespace wrinkle::maps
