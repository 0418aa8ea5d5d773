// The pictures of a bake on their way to files.
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

// What integers could not hold of a map.
struct Clamped {
    uint64_t numbers = 0;
    float least = 0, greatest = 1;

    void add(const Clamped& other);
};

// Rows of one map as its file stores them: channels interleaved, of this type. On all cores.
std::vector<std::byte> stored_rows(const BakedMap& map, PixelType type, const BakedRows& rows,
                                   uint32_t width, size_t lanes, Clamped& clamped);

// The options of a map's file in the size of its layout; layout_mark is kept, and a scale other
// than 1 as "wrinkle:scale".
WriterOptions writer_options(const BakedMap& map, PixelType type, uint32_t width, uint32_t height,
                             double scale);

// OUT with `suffix` (".1001") before the extension where OUT is the one map's file, else
// OUT/NAME.1001.png.
std::filesystem::path map_path(const std::filesystem::path& out, bool one_file,
                               const std::string& name, const std::string& suffix,
                               const std::string& extension);

struct MapFile {
    std::filesystem::path path;
    WriterOptions options;
};

// All files of one picture: none has its name before all are written.
class MapFiles {
public:
    // Makes the folders that are missing.
    static std::optional<MapFiles> open(const std::vector<MapFile>& files,
                                        Diagnostics& diagnostics);

    // The next rows of one of them.
    bool write(size_t file, std::span<const std::byte> rows, Diagnostics& diagnostics);
    bool finish(Diagnostics& diagnostics);

private:
    std::vector<ImageWriter> writers_;
};

}  // namespace wrinkle
