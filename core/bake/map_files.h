// Writes the maps of a texture set to files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "bake/maps.h"
#include "base/diagnostics.h"
#include "image/writer.h"

namespace wrinkle {

// Count and range of map values that were clamped to [0, 1] for an integer file.
struct Clamped {
    uint64_t numbers = 0;
    float least = 0, greatest = 1;

    void add(const Clamped& other);
};

// Encodes rows of one map for its file: interleaved channels of `type`. Counts clamped values of
// integer types in `clamped`. Uses all cores.
std::vector<std::byte> stored_rows(const BakedMap& map, PixelType type, const BakedRows& rows,
                                   uint32_t width, size_t lanes, Clamped& clamped);

// Returns the options of a map's file with the size of its layout. The file stores layout_mark, and
// "wrinkle:scale" if `scale` is not 1.
WriterOptions writer_options(const BakedMap& map, PixelType type, uint32_t width, uint32_t height,
                             double scale);

// If `one_file`, returns OUT with `suffix` (".1001") before the extension; else OUT/NAME.1001.png.
std::filesystem::path map_path(const std::filesystem::path& out, bool one_file,
                               const std::string& name, const std::string& suffix,
                               const std::string& extension);

struct MapFile {
    std::filesystem::path path;
    WriterOptions options;
};

// Opens the files of one texture set. Creates missing folders. Returns std::nullopt and appends
// diagnostics on failure.
std::optional<std::vector<ImageWriter>> open_maps(const std::vector<MapFile>& files,
                                                  Diagnostics& diagnostics);
// Gives the files their final names after all of them are written.
bool finish_maps(std::vector<ImageWriter>& writers, Diagnostics& diagnostics);

}  // namespace wrinkle
