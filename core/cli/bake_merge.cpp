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

bool check_parts(const std::vector<Part>& parts, Diagnostics& diagnostics) {
    const auto refuse = [&](size_t i, std::string message, std::string remedy) {
        diagnostics.add(file_problem(Severity::error, RuleId::bake_part, parts[i].folder.string(),
                                     std::move(message), std::move(remedy)));
    };
    const PartHeader& first = parts[0].header;
    for (size_t i = 0; i < parts.size(); ++i) {
        const PartHeader& header = parts[i].header;
        const std::string shard = shard_text(header.shard, header);
        if (header.identity != first.identity || header.shards != first.shards)
            refuse(i, "is a part of another bake than " + parts[0].folder.string(),
                   "shards of one graph, mesh, program and set of options");
        else if (header.done < header.last)
            refuse(i, shard + " is not finished", "bake it again, or with --resume");
        else if (header.shard > i + 1)
            refuse(i, shard_text(i + 1, header) + " is missing", "every shard once");
        else if (header.shard < i + 1)
            refuse(i, shard + " is there twice", "every shard once");
        else
            sums_of_rows(parts[i].folder, header, "bake " + shard + " again", diagnostics);
        if (diagnostics.has_errors()) return false;
    }
    if (parts.size() == first.shards) return true;
    refuse(0, shard_text(parts.size() + 1, first) + " is missing", "every shard once");
    return false;
}

// Files of the rows of one texture set, by map.
std::vector<OpenedFile> open_rows(const Part& part, size_t set) {
    std::vector<OpenedFile> files;
    for (size_t map = 0; map < part.header.maps.size(); ++map)
        files.emplace_back(std::fopen(rows_file(part.folder, set, map).c_str(), "rb"));
    return files;
}

// Returns the next band of one map; empty and the reason in `diagnostics` on failure.
std::vector<std::byte> read_band(const Part& part, uint64_t band, size_t map, std::FILE* from,
                                 Diagnostics& diagnostics) {
    std::vector<std::byte> bytes(part.header.rows_of(band) * part.header.row_bytes(map));
    if (from && std::fread(bytes.data(), 1, bytes.size(), from) == bytes.size()) return bytes;
    diagnostics.error(RuleId::bake_part,
                      rows_file(part.folder, part.header.set_of(band), map).string() +
                          " cannot be read: " + std::strerror(errno));
    return {};
}

}  // namespace

std::vector<Part> read_parts(const std::vector<std::string>& folders, Diagnostics& diagnostics) {
    std::vector<Part> parts;
    for (const std::string& folder : folders)
        if (auto header = read_header(folder, diagnostics))
            parts.push_back({folder, std::move(*header)});
    std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.header.shard; });
    if (diagnostics.has_errors() || !check_parts(parts, diagnostics)) return {};
    return parts;
}

BakeOutcome join_parts(const std::vector<Part>& parts, const std::string& output, uint32_t threads,
                       Progress& progress) {
    BakeOutcome outcome;
    std::vector<MapFile> files;
    std::optional<std::vector<ImageWriter>> to;
    for (const Part& part : parts) {
        const PartHeader& header = part.header;
        std::vector<OpenedFile> from;
        for (uint64_t band = header.first; band < header.last; ++band) {
            const bool begins = band % header.bands() == 0;
            if (begins) files = header.files(output, header.set_of(band), threads);
            if (begins) to = open_maps(files, outcome.environment);
            if (!to) return outcome;
            if (begins || from.empty()) from = open_rows(part, header.set_of(band));
            for (size_t map = 0; map < from.size(); ++map) {
                const auto rows = read_band(part, band, map, from[map].get(), outcome.environment);
                if (rows.empty() || !(*to)[map].write_stored(rows, outcome.environment))
                    return outcome;
            }
            progress.add(uint64_t{header.rows_of(band)} * header.width());
            if (is_interrupted()) return outcome;
            if ((band + 1) % header.bands() > 0) continue;
            if (!finish_maps(*to, outcome.environment)) return outcome;
            for (const MapFile& file : files)
                outcome.files.push_back(file.path.string());
        }
    }
    outcome.done = true;
    return outcome;
}

}  // namespace wrinkle::cli
