// Merges the parts of a bake into its output files.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/diagnostics.h"
#include "base/file.h"
#include "cli/bake_run.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

std::string shard_text(uint64_t shard, const PartHeader& header) {
    return "shard " + std::to_string(shard) + " of " + std::to_string(header.shards);
}

bool check_parts(const std::vector<fs::path>& folders, const std::vector<PartHeader>& headers,
                 Diagnostics& diagnostics) {
    const auto refuse = [&](size_t i, std::string message, std::string remedy) {
        diagnostics.add(file_problem(Severity::error, folders[i].string(), std::move(message),
                                     std::move(remedy)));
    };
    for (size_t i = 0; i < headers.size(); ++i) {
        const PartHeader& header = headers[i];
        const std::string shard = shard_text(header.shard, header);
        if (header.identity != headers[0].identity || header.shards != headers[0].shards)
            refuse(i, "is a part of another bake than " + folders[0].string(),
                   "shards of one graph, mesh, program and set of options");
        else if (header.done < header.last)
            refuse(i, shard + " is not finished", "bake it again, or with --resume");
        else if (header.shard > i + 1)
            refuse(i, shard_text(i + 1, header) + " is missing", "every shard once");
        else if (header.shard < i + 1)
            refuse(i, shard + " is there twice", "every shard once");
        else
            has_its_rows(folders[i], header, "bake " + shard + " again", diagnostics);
        if (diagnostics.has_errors()) return false;
    }
    if (headers.size() == headers[0].shards) return true;
    refuse(0, shard_text(headers.size() + 1, headers[0]) + " is missing", "every shard once");
    return false;
}

// Reads the rows of one map of one image from consecutive parts.
class JoinedRows {
public:
    JoinedRows(const std::vector<fs::path>& folders, const std::vector<PartHeader>& headers,
               size_t set, size_t map)
        : folders_(folders), headers_(headers), set_(set), map_(map) {}

    // Returns row of tiles `band`, the next one; empty and the reason in `why` on failure.
    std::vector<std::byte> next(uint64_t band, std::string& why) {
        while (part_ + 1 < headers_.size() && band >= headers_[part_].last)
            open(part_ + 1);
        if (!file_) open(part_);
        std::vector<std::byte> bytes(headers_[part_].rows_of(band) *
                                     headers_[part_].row_bytes(map_));
        if (file_ && std::fread(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size())
            return bytes;
        why = rows_file(folders_[part_], set_, map_).string() +
              " cannot be read: " + std::strerror(errno);
        return {};
    }

private:
    void open(size_t part) {
        part_ = part;
        file_.reset(std::fopen(rows_file(folders_[part], set_, map_).c_str(), "rb"));
    }

    const std::vector<fs::path>& folders_;
    const std::vector<PartHeader>& headers_;
    size_t set_, map_, part_ = 0;
    OpenedFile file_;
};

bool join_set(const std::vector<fs::path>& folders, const std::vector<PartHeader>& headers,
              size_t set, const std::vector<MapFile>& files, Progress& progress,
              Diagnostics& diagnostics) {
    const PartHeader& header = headers[0];
    auto writers = open_maps(files, diagnostics);
    if (!writers) return false;
    std::vector<JoinedRows> rows;
    for (size_t map = 0; map < files.size(); ++map)
        rows.emplace_back(folders, headers, set, map);
    for (uint64_t i = 0; i < header.bands(); ++i) {
        const uint64_t band = set * uint64_t{header.bands()} + i;
        for (size_t map = 0; map < files.size(); ++map) {
            std::string why;
            const std::vector<std::byte> bytes = rows[map].next(band, why);
            if (bytes.empty()) diagnostics.error(why);
            if (bytes.empty() || !(*writers)[map].write_stored(bytes, diagnostics)) return false;
        }
        progress.add(uint64_t{header.rows_of(band)} * header.width());
        if (Interruption::requested()) return false;
    }
    return finish_maps(*writers, diagnostics);
}

}  // namespace

std::vector<PartHeader> read_parts(std::vector<fs::path>& folders, Diagnostics& diagnostics) {
    std::vector<std::pair<PartHeader, fs::path>> parts;
    for (const fs::path& folder : folders)
        if (auto header = read_header(folder, diagnostics))
            parts.emplace_back(std::move(*header), folder);
    if (diagnostics.has_errors() || parts.empty()) return {};
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.first.shard < b.first.shard; });
    std::vector<PartHeader> headers;
    folders.clear();
    for (auto& [header, folder] : parts) {
        headers.push_back(std::move(header));
        folders.push_back(std::move(folder));
    }
    if (!check_parts(folders, headers, diagnostics)) return {};
    return headers;
}

BakeOutcome join_parts(const std::vector<fs::path>& folders, const std::vector<PartHeader>& headers,
                       const std::string& output, uint32_t threads, Progress& progress) {
    BakeOutcome outcome;
    for (size_t set = 0; set < headers[0].sets.size(); ++set) {
        const auto files = headers[0].files(output, set, threads);
        if (!join_set(folders, headers, set, files, progress, outcome.environment)) return outcome;
        for (const MapFile& file : files)
            outcome.files.push_back(file.path.string());
    }
    outcome.done = true;
    return outcome;
}

}  // namespace wrinkle::cli
