#include "cli/bake_run.h"

#include <algorithm>

#include "bake/texture_set.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// Bakes images and passes their rows, in the pixel types of the files, to a sink.
class SetBaker {
public:
    SetBaker(const BakeJob& job, Progress& progress) : job_(job), progress_(progress) {}

    // Statistics of all finished rows, including those of earlier runs.
    BakeReport report;

    // Bakes rows [first, last) of an image; `take.band` may be empty. Returns false on failure or
    // interruption.
    bool bake(size_t number, uint32_t first, uint32_t last, BakeSinks take) {
        const TextureSet& set = job_.sets[number];
        const BakePlan& plan = job_.plans[set.run];
        const std::vector<Texture> textures = job_.textures.textures_of(plan.resources);
        TextureSetInput input;
        input.mesh = &job_.mesh;
        input.plan = &plan;
        input.textures = textures;
        for (const WantedMap& map : job_.request.maps)
            input.types.push_back(map.type);
        input.layout = {job_.request.width, job_.request.height, set.square, job_.options.samples};
        input.dilate = job_.options.dilate;
        input.threads = job_.options.threads;
        take.band = [this, band = std::move(take.band)](uint32_t row, uint64_t texels) {
            if (band && !band(row, texels)) return false;
            progress_.add(texels);
            return !Interruption::requested();
        };
        return bake_texture_set(input, first, last, take, report);
    }

    void finish(bool done, BakeOutcome& outcome) const {
        outcome.done = done;
        if (done)
            report.append_warnings(job_.options.file, job_.options.mesh, job_.plans[0].maps,
                                   outcome.warnings);
    }

private:
    const BakeJob& job_;
    Progress& progress_;
};

}  // namespace

BakeOutcome bake_files(const BakeJob& job, const PartHeader& header, Progress& progress) {
    BakeOutcome outcome;
    SetBaker baker(job, progress);
    const auto bake_set = [&](size_t number) {
        const auto files = header.files(job.options.output, number, job.options.threads);
        auto writers = open_maps(files, outcome.environment);
        if (!writers) return false;
        const auto keep = [&](size_t map, std::span<const std::byte> bytes) {
            return (*writers)[map].write_stored(bytes, outcome.environment);
        };
        if (!baker.bake(number, 0, job.request.height, {keep, {}}) ||
            !finish_maps(*writers, outcome.environment))
            return false;
        for (const MapFile& file : files)
            outcome.files.push_back(file.path.string());
        return true;
    };
    bool whole = true;
    for (size_t number = 0; whole && number < job.sets.size(); ++number)
        whole = bake_set(number);
    baker.finish(whole, outcome);
    return outcome;
}

BakeOutcome bake_part(const BakeJob& job, const fs::path& folder, PartHeader header,
                      Progress& progress) {
    BakeOutcome outcome;
    SetBaker baker(job, progress);
    Diagnostics opened;
    auto part = PartWriter::open(folder, std::move(header), job.options.resume, opened);
    (part ? outcome.warnings : outcome.environment).append(opened);
    const uint64_t bands = job.bands();
    if (part) baker.report = part->header().found;
    bool whole = part.has_value();
    for (uint64_t first = whole ? part->header().first : 0; whole && first < part->header().done;
         ++first)
        progress.skip(uint64_t{part->header().rows_of(first)} * job.request.width);
    while (whole && part->header().done < part->header().last) {
        const uint64_t first = part->header().done;
        const size_t number = first / bands;
        const uint64_t last = std::min(part->header().last, (number + 1) * bands);
        const auto row_of = [&](uint64_t band) {
            return static_cast<uint32_t>(
                std::min<uint64_t>((band - number * bands) * bake_tile, job.request.height));
        };
        const auto keep = [&](size_t map, std::span<const std::byte> bytes) {
            return part->rows(map, bytes, outcome.environment);
        };
        const auto band = [&](uint32_t row, uint64_t) {
            return part->done(number * bands + (row + bake_tile - 1) / bake_tile, baker.report,
                              outcome.environment);
        };
        whole = part->begin(number, outcome.environment) &&
                baker.bake(number, row_of(first), row_of(last), {keep, band});
    }
    baker.finish(whole, outcome);
    outcome.files = {header_file(folder).string()};
    return outcome;
}

}  // namespace wrinkle::cli
