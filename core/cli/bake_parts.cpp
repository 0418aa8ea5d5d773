#include "cli/bake_parts.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/diagnostics.h"
#include "base/file.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// Returns the XXH64 of the first `size` bytes of a file; std::nullopt and the reason in `why` on
// failure.
std::optional<Xxh64> sum_of_rows(const fs::path& path, uint64_t size, std::string& why) {
    Xxh64 sum;
    const OpenedFile file = open_to_read(path, why);
    if (!file) return {};
    std::vector<std::byte> block(size_t{1} << 20);
    while (size > 0) {
        const size_t count =
            std::fread(block.data(), 1, std::min<uint64_t>(size, block.size()), file.get());
        if (count == 0) {
            why = std::ferror(file.get()) ? "cannot be read" : "ends early";
            return {};
        }
        sum.add(std::span(block.data(), count));
        size -= count;
    }
    return sum;
}

// Resumes from the finished rows of the same bake and returns their checksums. If any file is
// damaged, all rows are discarded with a warning, because `found` is not stored per file.
std::vector<Xxh64> take_finished_rows(const fs::path& folder, PartHeader& header,
                                      Diagnostics& diagnostics) {
    Diagnostics damage;
    const auto before = read_header(folder, damage);
    const bool is_same = before && before->identity == header.identity &&
                         before->shard == header.shard && before->shards == header.shards &&
                         before->first == header.first && before->last == header.last;
    if (is_same)
        if (auto sums = sums_of_rows(folder, *before, "", damage)) {
            header.done = before->done;
            header.found = before->found;
            header.sums = before->sums;
            return std::move(*sums);
        }
    for (Diagnostic problem : damage.list()) {
        problem.severity = Severity::warning;
        problem.message += "; all rows are baked again";
        problem.expected.clear();
        diagnostics.add(std::move(problem));
    }
    return {};
}

}  // namespace

PartHeader header_of(const BakeJob& job) {
    PartHeader header;
    header.identity = job.identity;
    header.shard = job.request.shard;
    header.shards = job.request.shards;
    for (size_t i = 0; i < job.request.maps.size(); ++i) {
        const WantedMap& wanted = job.request.maps[i];
        WriterOptions writer = writer_options(job.plans[0].maps[i], wanted.type, job.request.width,
                                              job.request.height, job.options.scale);
        writer.compression = job.options.compression;
        writer.tile = job.options.tile;
        header.maps.push_back({wanted.request.name, wanted.extension, std::move(writer)});
    }
    for (const TextureSet& set : job.sets)
        header.sets.push_back(set.suffix);
    const uint64_t all = header.sets.size() * uint64_t{header.bands()};
    header.first = header.done = all * (header.shard - 1) / header.shards;
    header.last = all * header.shard / header.shards;
    return header;
}

fs::path header_file(const fs::path& folder) {
    return folder / "bake.json";
}

fs::path rows_file(const fs::path& folder, size_t set, size_t map) {
    return folder / (std::to_string(set) + "-" + std::to_string(map) + ".rows");
}

std::optional<PartHeader> read_header(const fs::path& folder, Diagnostics& diagnostics) {
    const fs::path file = header_file(folder);
    std::string why, remedy = "a folder that bake --shard wrote";
    const auto text = read_file(file, why);
    auto header = text ? header_of_json(*text) : std::nullopt;
    if (text && !header) {
        why = "is damaged, or does not describe a part of a bake";
        remedy = "bake that shard again";
    }
    if (!header)
        diagnostics.add(file_problem(Severity::error, RuleId::bake_part, file.string(), why,
                                     std::move(remedy)));
    return header;
}

std::optional<std::vector<Xxh64>> sums_of_rows(const fs::path& folder, const PartHeader& header,
                                               const std::string& remedy,
                                               Diagnostics& diagnostics) {
    std::vector<Xxh64> sums;
    for (size_t i = 0; i < header.files_with_rows(); ++i) {
        const size_t set = header.set_of(header.first) + i / header.maps.size();
        const size_t map = i % header.maps.size();
        const fs::path file = rows_file(folder, set, map);
        std::string why;
        auto sum = sum_of_rows(file, header.bytes_of_rows(set, map), why);
        if (sum && sum->digest() != header.sums[i])
            why = "does not hold the rows that were baked: their checksum is another";
        if (!why.empty()) {
            diagnostics.add(
                file_problem(Severity::error, RuleId::bake_part, file.string(), why, remedy));
            return {};
        }
        sums.push_back(std::move(*sum));
    }
    return sums;
}

std::optional<PartWriter> PartWriter::open(const fs::path& folder, PartHeader header, bool resume,
                                           Diagnostics& diagnostics) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (fs::exists(header_file(folder), error) && !is_regular_file(header_file(folder), error)) {
        diagnostics.add(file_problem(Severity::error, RuleId::output_path,
                                     header_file(folder).string(), "is not a regular file",
                                     "remove it, or another folder"));
        return {};
    }
    PartWriter writer;
    if (resume && fs::exists(header_file(folder), error))
        writer.sums_ = take_finished_rows(folder, header, diagnostics);
    if (header.done == header.first) fs::remove(header_file(folder), error);  // rewritten below
    writer.folder_ = folder;
    writer.header_ = std::move(header);
    if (!writer.write_header(diagnostics)) return {};
    return writer;
}

bool PartWriter::fail(size_t map, Diagnostics& diagnostics) const {
    diagnostics.add(file_problem(Severity::error, RuleId::file_unwritable,
                                 rows_file(folder_, set_, map).string(),
                                 "rows of the map '" + header_.maps[map].name +
                                     "' cannot be written: " + std::strerror(errno),
                                 "a folder that can be written to and has room"));
    return false;
}

bool PartWriter::write_header(Diagnostics& diagnostics) const {
    std::string why;
    if (write_file(header_file(folder_), header_json(header_), why)) return true;
    diagnostics.add(file_problem(Severity::error, RuleId::file_unwritable,
                                 header_file(folder_).string(), why, ""));
    return false;
}

bool PartWriter::begin(size_t set, Diagnostics& diagnostics) {
    set_ = set;
    files_.clear();
    sums_.resize(header_.sum_index(set, header_.maps.size()));
    for (size_t map = 0; map < header_.maps.size(); ++map) {
        const fs::path path = rows_file(folder_, set, map);
        const uint64_t kept = header_.bytes_of_rows(set, map);
        if (kept == 0) unlink(path.c_str());  // do not write through a pipe or a link
        files_.emplace_back(std::fopen(path.c_str(), kept > 0 ? "r+b" : "wb"));
        // Overwrite rows that bake.json does not count.
        if (!files_[map] || std::fseek(files_[map].get(), static_cast<long>(kept), SEEK_SET) != 0)
            return fail(map, diagnostics);
    }
    return true;
}

bool PartWriter::rows(size_t map, std::span<const std::byte> bytes, Diagnostics& diagnostics) {
    std::FILE* file = files_[map].get();
    if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0)
        return fail(map, diagnostics);
    sums_[header_.sum_index(set_, map)].add(bytes);
    return true;
}

bool PartWriter::record(uint64_t bands, const BakeReport& found, Diagnostics& diagnostics) {
    header_.done = bands;
    header_.found = found;
    header_.sums.clear();
    for (const Xxh64& sum : sums_)
        header_.sums.push_back(sum.digest());
    return write_header(diagnostics);
}

}  // namespace wrinkle::cli
