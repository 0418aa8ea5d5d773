// bake.json of a part of a bake (cli/bake_parts.h): its data and its JSON text.
//
// The text ends with the SHA-256 of all bytes before it. The hash detects damage but does not
// authenticate: header_of_json() validates every value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bake/map_files.h"
#include "bake/texture_set.h"

namespace wrinkle::cli {

struct PartHeader {
    struct Map {
        std::string name, extension;
        WriterOptions writer;  // without the thread count
    };
    std::string identity;
    uint32_t shard = 1, shards = 1;
    std::vector<Map> maps;
    std::vector<std::string> sets;  // file name suffixes
    uint64_t first = 0, last = 0, done = 0;
    std::vector<std::string> sums;  // checksums of the finished rows per file, by sum_index()
    BakeReport found;               // statistics of the finished rows

    uint32_t width() const { return maps[0].writer.width; }
    uint32_t height() const { return maps[0].writer.height; }
    uint32_t bands() const { return (height() + bake_tile - 1) / bake_tile; }
    size_t row_bytes(size_t map) const;
    // Pixel rows in row of tiles `band`.
    uint32_t rows_of(uint64_t band) const;
    uint64_t set_of(uint64_t band) const { return band / bands(); }
    // Number of files that hold finished rows.
    size_t files_with_rows() const {
        return done == first ? 0 : (set_of(done - 1) - set_of(first) + 1) * maps.size();
    }
    // Bytes of the finished rows in the file of one map of one image.
    uint64_t bytes_of_rows(size_t set, size_t map) const;
    size_t sum_index(size_t set, size_t map) const {
        return (set - set_of(first)) * maps.size() + map;
    }
    // Output files: OUT for one map, OUT/MAP.EXT for several.
    std::vector<MapFile> files(const std::string& output, size_t set, uint32_t threads) const;
};

std::string header_json(const PartHeader& header);
// Returns std::nullopt if the text is damaged or does not describe a part.
std::optional<PartHeader> header_of_json(const std::string& text);
// Appends the SHA-256 of `text` and the closing brace, as in header_json().
std::string with_sum(std::string text);

}  // namespace wrinkle::cli
