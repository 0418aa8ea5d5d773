#include "cli/bake_run.h"

#include <algorithm>

#include "bake/texture_set.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// Bakes bands [first, last) of one texture set and passes their rows, in the pixel types of the
// files, to `take`. Returns false on failure or interruption.
bool bake_bands(const BakeJob& job, uint64_t first, uint64_t last, BakeSinks take,
                Progress& progress, BakeReport& report) {
    const uint64_t number = first / job.bands();
    const TextureSet& set = job.sets[number];
    const BakePlan& plan = job.plans[set.run];
    const std::vector<Texture> textures = job.textures.textures_of(plan.resources);
    TextureSetInput input;
    input.mesh = &job.mesh;
    input.plan = &plan;
    input.textures = textures;
    for (const WantedMap& map : job.request.maps)
        input.types.push_back(map.type);
    input.layout = {job.request.width, job.request.height, set.square, job.options.samples};
    input.dilate = job.options.dilate;
    input.threads = job.options.threads;
    take.band = [&progress, band = std::move(take.band)](uint32_t row, uint64_t texels) {
        if (band && !band(row, texels)) return false;
        progress.add(texels);
        return !is_interrupted();
    };
    const auto row_of = [&](uint64_t band) {
        return static_cast<uint32_t>(
            std::min<uint64_t>((band - number * job.bands()) * bake_tile, job.request.height));
    };
    return bake_texture_set(input, row_of(first), row_of(last), take, report);
}

void finish(const BakeJob& job, const BakeReport& report, BakeOutcome& outcome) {
    outcome.done = true;
    report.append_warnings(job.options.file, job.options.mesh, job.plans[0].maps, outcome.warnings);
}

}  // namespace

BakeOutcome bake_files(const BakeJob& job, const PartHeader& header, Progress& progress) {
    BakeOutcome outcome;
    BakeReport report;
    for (uint64_t set = 0; set < job.sets.size(); ++set) {
        const auto files = header.files(job.options.output, set, job.options.threads);
        auto writers = open_maps(files, outcome.environment);
        if (!writers) return outcome;
        const auto write = [&](size_t map, std::span<const std::byte> bytes) {
            return (*writers)[map].write_stored(bytes, outcome.environment);
        };
        if (!bake_bands(job, set * job.bands(), (set + 1) * job.bands(), {write, {}}, progress,
                        report) ||
            !finish_maps(*writers, outcome.environment))
            return outcome;
        for (const MapFile& file : files)
            outcome.files.push_back(file.path.string());
    }
    finish(job, report, outcome);
    return outcome;
}

BakeOutcome bake_part(const BakeJob& job, const fs::path& folder, PartHeader header,
                      Progress& progress) {
    BakeOutcome outcome;
    outcome.files = {header_file(folder).string()};
    Diagnostics opened;
    auto part = PartWriter::open(folder, std::move(header), job.options.resume, opened);
    (part ? outcome.warnings : outcome.environment).append(opened);
    if (!part) return outcome;
    const PartHeader& state = part->header();
    BakeReport report = state.found;
    for (uint64_t band = state.first; band < state.done; ++band)
        progress.skip(uint64_t{state.rows_of(band)} * job.request.width);
    const auto write = [&](size_t map, std::span<const std::byte> bytes) {
        return part->rows(map, bytes, outcome.environment);
    };
    const auto record = [&](uint32_t row, uint64_t) {  // may end several bands
        const uint64_t set = state.set_of(state.done);
        return part->record(set * job.bands() + (row + bake_tile - 1) / bake_tile, report,
                            outcome.environment);
    };
    while (state.done < state.last) {
        const uint64_t set = state.set_of(state.done);
        if (!part->begin(set, outcome.environment) ||
            !bake_bands(job, state.done, std::min(state.last, (set + 1) * job.bands()),
                        {write, record}, progress, report))
            return outcome;
    }
    finish(job, report, outcome);
    return outcome;
}

}  // namespace wrinkle::cli
