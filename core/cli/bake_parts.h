// A folder that holds a part of a bake: a shard, or a bake that can be resumed.
//
//   bake.json   the request, how many rows of tiles are done, and checksums
//   P-M.rows    those of map M of picture P, one after the other from the top, in the file's type
//
// The rows of tiles of all pictures are counted one picture after the other; a part holds those
// from `first` to `last`, without `last`, of which those before `done` are in the files. bake.json
// holds the XXH64 of the done rows of each file, and the SHA-256 of its own text. It is replaced
// after the rows that it counts are in their files, which may by then hold more: a program may be
// killed at any time. Checking a part reads all its rows once, O(bytes).
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/xxh64.h"
#include "cli/bake_header.h"
#include "cli/bake_job.h"

namespace wrinkle::cli {

PartHeader header_of(const BakeJob& job);

// std::nullopt with an error that names the file.
std::optional<PartHeader> read_header(const std::filesystem::path& folder,
                                      Diagnostics& diagnostics);

std::filesystem::path header_file(const std::filesystem::path& folder);
std::filesystem::path rows_file(const std::filesystem::path& folder, size_t picture, size_t map);

// True if the folder holds the rows that the header counts, each byte of them; otherwise false
// with the first file that does not in `diagnostics`, as an error with this remedy.
bool has_its_rows(const std::filesystem::path& folder, const PartHeader& header,
                  const std::string& remedy, Diagnostics& diagnostics);

class PartWriter {
public:
    // Continues where the same bake was stopped, if `resume` is set and the folder holds it; else
    // begins at the first row, with a warning if the folder was damaged. header().done says where.
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
    std::vector<std::unique_ptr<std::FILE, Close>> files_;  // of this image, by map
    std::vector<Xxh64> sums_;                               // of what was written to them
};

}  // namespace wrinkle::cli
