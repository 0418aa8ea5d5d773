#include "cli/bake_run.h"

#include <algorithm>

#include "base/text.h"
#include "cli/interrupt.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

struct RowRange {
    uint32_t first = 0, last = 0;  // texels from the top
};

// What a bake has to tell of its maps, when all is done.
struct Told {
    uint64_t overlapped = 0;
    glm::dvec2 overlap_uv{0};
    uint32_t overlap_triangle = 0;
    uint64_t not_finite = 0;
    std::vector<Clamped> clamped;  // by map

    void add(const BakeFindings& found, const UvLayout& layout) {
        if (overlapped == 0 && found.overlapped > 0) {
            overlap_uv = layout.uv(found.overlap_x + 0.5, found.overlap_y + 0.5);
            overlap_triangle = found.overlap_triangle;
        }
        overlapped += found.overlapped;
        not_finite += found.not_finite;
    }
};

void told_warning(const std::string& file, std::string message, std::string expected,
                  Diagnostics& diagnostics) {
    Diagnostic problem;
    problem.severity = Severity::warning;
    problem.where.file = file;
    problem.message = std::move(message);
    problem.expected = std::move(expected);
    diagnostics.add(std::move(problem));
}

void tell(const Told& told, const BakeJob& job, Diagnostics& warnings) {
    if (told.overlapped > 0)
        told_warning(job.options.mesh,
                     std::to_string(told.overlapped) +
                         " texels are covered by more than one triangle; at uv " +
                         shortest(static_cast<float>(told.overlap_uv.x)) + "," +
                         shortest(static_cast<float>(told.overlap_uv.y)) + " triangle " +
                         std::to_string(told.overlap_triangle) + " is hidden by one before it",
                     "a uv layout without overlaps", warnings);
    if (told.not_finite > 0)
        told_warning(job.options.file,
                     std::to_string(told.not_finite) + " texels hold a number that is not finite",
                     "integer files hold 0 there", warnings);
    for (size_t map = 0; map < told.clamped.size(); ++map) {
        const Clamped& clamped = told.clamped[map];
        if (clamped.numbers == 0) continue;
        told_warning(job.options.file,
                     "the map '" + job.wishes.maps[map].request.name + "' holds " +
                         std::to_string(clamped.numbers) + " numbers that integers do not, from " +
                         shortest(clamped.least) + " to " + shortest(clamped.greatest),
                     "--type half or float, or --scale", warnings);
    }
}

// Bakes pictures and hands their stored rows on.
class PictureBaker {
public:
    PictureBaker(const BakeJob& job, Progress& progress) : job_(job), progress_(progress) {
        told_.clamped.resize(job.wishes.maps.size());
    }

    // `keep(map, bytes)` takes the rows of one map, `band(row)` follows those of all down to `row`.
    template <class Keep, class Band>
    bool bake(size_t number, RowRange rows, const Keep& keep, const Band& band) {
        const BakePicture& picture = job_.pictures[number];
        const BakePlan& plan = job_.plans[picture.run];
        const UvLayout layout = {job_.wishes.width, job_.wishes.height, picture.square,
                                 job_.options.samples};
        const UvRaster raster(job_.mesh, layout);
        const std::vector<Texture> textures = job_.textures.textures_of(plan.resources);
        BakeInput input;
        input.mesh = &job_.mesh;
        input.program = &plan.program;
        input.textures = textures;
        input.unit = plan.unit;
        input.dilate = job_.options.dilate;
        const auto take = [&](const BakedRows& baked) {
            for (size_t map = 0; map < plan.maps.size(); ++map)
                if (!keep(map, stored_rows(plan.maps[map], job_.wishes.maps[map].type, baked,
                                           layout.width, plan.lanes, told_.clamped[map])))
                    return false;
            if (!band(baked.first + baked.count)) return false;
            progress_.add(uint64_t{baked.count} * layout.width);
            return !Interruption::requested();
        };
        BakeFindings found;
        const bool whole =
            bake_rows(input, raster, rows.first, rows.last, job_.options.threads, take, found);
        told_.add(found, layout);
        return whole;
    }

    void finish(bool whole, BakeOutcome& outcome) const {
        if (!whole)
            outcome.end = outcome.environment.has_errors() ? BakeEnd::failed : BakeEnd::interrupted;
        else
            tell(told_, job_, outcome.warnings);
    }

private:
    const BakeJob& job_;
    Progress& progress_;
    Told told_;
};

void list_files(const std::vector<MapFile>& files, std::vector<std::string>& names) {
    for (const MapFile& file : files)
        names.push_back(file.path.string());
}

}  // namespace

BakeOutcome bake_files(const BakeJob& job, const PartHeader& header, Progress& progress) {
    BakeOutcome outcome;
    PictureBaker baker(job, progress);
    const auto picture = [&](size_t number) {
        const auto files = header.files(job.options.output, number, job.options.threads);
        auto writers = MapFiles::open(files, outcome.environment);
        if (!writers) return false;
        const auto keep = [&](size_t map, const std::vector<std::byte>& bytes) {
            return writers->write(map, bytes, outcome.environment);
        };
        const auto band = [](uint32_t) { return true; };
        if (!baker.bake(number, {0, job.wishes.height}, keep, band) ||
            !writers->finish(outcome.environment))
            return false;
        list_files(files, outcome.files);
        return true;
    };
    bool whole = true;
    for (size_t number = 0; whole && number < job.pictures.size(); ++number)
        whole = picture(number);
    baker.finish(whole, outcome);
    return outcome;
}

BakeOutcome bake_part(const BakeJob& job, const fs::path& folder, PartHeader header,
                      Progress& progress) {
    BakeOutcome outcome;
    PictureBaker baker(job, progress);
    auto part =
        PartWriter::open(folder, std::move(header), job.options.resume, outcome.environment);
    const uint64_t bands = job.bands();
    bool whole = part.has_value();
    for (uint64_t first = whole ? part->header().first : 0; whole && first < part->header().done;
         ++first)
        progress.skip(uint64_t{part->header().rows_of(first)} * job.wishes.width);
    while (whole && part->header().done < part->header().last) {
        const uint64_t first = part->header().done;
        const size_t number = first / bands;
        const uint64_t last = std::min(part->header().last, (number + 1) * bands);
        const auto row_of = [&](uint64_t band) {
            return static_cast<uint32_t>(
                std::min<uint64_t>((band - number * bands) * bake_tile, job.wishes.height));
        };
        const auto keep = [&](size_t map, const std::vector<std::byte>& bytes) {
            return part->rows(map, bytes, outcome.environment);
        };
        const auto band = [&](uint32_t row) {
            return part->done(number * bands + (row + bake_tile - 1) / bake_tile,
                              outcome.environment);
        };
        whole = part->begin(number, outcome.environment) &&
                baker.bake(number, {row_of(first), row_of(last)}, keep, band);
    }
    baker.finish(whole, outcome);
    outcome.files = {header_file(folder).string()};
    return outcome;
}

}  // namespace wrinkle::cli
