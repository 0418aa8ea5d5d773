// A folder that holds a part of a bake: what is done of a shard, or of a bake that can go on.
//
//   bake.json   what was asked for, and how many rows of tiles are done
//   P-M.rows    those of map M of picture P, one after the other from the top, in the file's type
//
// The rows of tiles of all pictures are counted one picture after the other; a part holds those
// from `first` to `last`, without `last`, of which those before `done` are in the files. bake.json
// is written after the rows it tells of, so a program may be killed at any time.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bake/picture.h"
#include "base/diagnostics.h"
#include "cli/bake_job.h"

namespace wrinkle::cli {

struct PartHeader {
    struct Map {
        std::string name, extension;
        WriterOptions writer;  // but for its threads
    };
    std::string identity;
    uint32_t shard = 1, shards = 1;
    std::vector<Map> maps;
    std::vector<std::string> pictures;  // the suffixes of their files
    uint64_t first = 0, last = 0, done = 0;
    BakeReport found;  // in what is done

    uint32_t width() const { return maps[0].writer.width; }
    uint32_t height() const { return maps[0].writer.height; }
    uint32_t bands() const { return (height() + bake_tile - 1) / bake_tile; }
    size_t row_bytes(size_t map) const;
    // Of row of tiles `band` of its picture.
    uint32_t rows_of(uint64_t band) const;
    // Of one map it is OUT, of several OUT/MAP.EXT.
    std::vector<MapFile> files(const std::string& output, size_t picture, uint32_t threads) const;
};

PartHeader header_of(const BakeJob& job);

// Nothing with an error that names the folder.
std::optional<PartHeader> read_header(const std::filesystem::path& folder,
                                      Diagnostics& diagnostics);

std::filesystem::path header_file(const std::filesystem::path& folder);
std::filesystem::path rows_file(const std::filesystem::path& folder, size_t picture, size_t map);

class PartWriter {
public:
    // Goes on where the same bake was stopped, if `resume` is set and the folder holds it; else
    // from the beginning. header().done says where.
    static std::optional<PartWriter> open(const std::filesystem::path& folder, PartHeader header,
                                          bool resume, Diagnostics& diagnostics);

    const PartHeader& header() const { return header_; }
    bool begin(size_t picture, Diagnostics& diagnostics);
    bool rows(size_t map, std::span<const std::byte> bytes, Diagnostics& diagnostics);
    // How many rows of tiles are in the files by now, and what was found in them.
    bool done(uint64_t bands, const BakeReport& found, Diagnostics& diagnostics);

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    bool fail(size_t map, Diagnostics& diagnostics) const;
    bool write_header(Diagnostics& diagnostics) const;

    std::filesystem::path folder_;
    PartHeader header_;
    size_t picture_ = 0;
    std::vector<std::unique_ptr<std::FILE, Close>> files_;  // of the picture at hand
};

}  // namespace wrinkle::cli
