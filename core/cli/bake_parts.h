// Folder that holds a part of a bake: a shard, or a bake that can be resumed.
//
//   bake.json   the request, the number of finished bands, and checksums (cli/bake_header.h)
//   S-M.rows    rows of map M of texture set S, top to bottom, in the pixel type of the output file
//
// A band is a row of tiles (bake/bake.h); all texture sets number their bands consecutively. A part
// covers bands [first, last); those before `done` are in the files.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/checksum.h"
#include "base/diagnostics.h"
#include "base/file.h"
#include "cli/bake_header.h"
#include "cli/bake_job.h"

namespace wrinkle::cli {

// Returns the header of the job's shard, with no band finished.
PartHeader header_of(const BakeJob& job);

// Returns std::nullopt and reports an error that names the file on failure.
std::optional<PartHeader> read_header(const std::filesystem::path& folder,
                                      Diagnostics& diagnostics);

std::filesystem::path header_file(const std::filesystem::path& folder);
std::filesystem::path rows_file(const std::filesystem::path& folder, size_t set, size_t map);

// Returns the checksums of the rows that the header counts, by PartHeader::sum_index(). If one does
// not match, returns std::nullopt and reports the damaged file as an error with `remedy`. Reads all
// rows once, O(bytes).
std::optional<std::vector<Xxh64>> sums_of_rows(const std::filesystem::path& folder,
                                               const PartHeader& header, const std::string& remedy,
                                               Diagnostics& diagnostics);

// Replaces bake.json after the rows that it counts are written, so the files may hold more rows:
// the program may be killed at any time.
class PartWriter {
public:
    // Resumes the same bake if `resume` is set and the folder holds it. Otherwise starts at the
    // first band and discards the folder's rows, with a warning if they are damaged. header().done
    // is the first band to bake. Returns std::nullopt and reports an error if bake.json cannot be
    // written.
    static std::optional<PartWriter> open(const std::filesystem::path& folder, PartHeader header,
                                          bool resume, Diagnostics& diagnostics);

    const PartHeader& header() const { return header_; }
    // Call begin() for each texture set; then, for each band, rows() for each map, and record().
    // They return false and report an error on failure.
    bool begin(size_t set, Diagnostics& diagnostics);
    bool rows(size_t map, std::span<const std::byte> bytes, Diagnostics& diagnostics);
    // Records in bake.json that all bands before number `bands` are written, and the statistics of
    // the part.
    bool record(uint64_t bands, const BakeReport& found, Diagnostics& diagnostics);

private:
    bool fail(size_t map, Diagnostics& diagnostics) const;
    bool write_header(Diagnostics& diagnostics) const;

    std::filesystem::path folder_;
    PartHeader header_;
    size_t set_ = 0;
    std::vector<OpenedFile> files_;  // files of the current texture set, by map
    std::vector<Xxh64> sums_;        // checksums of the written rows, by PartHeader::sum_index()
};

}  // namespace wrinkle::cli
