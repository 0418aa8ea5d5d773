#include "editor/model/bake/bake.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "bake/mesh_check.h"
#include "bake/texture_set.h"
#include "base/file.h"
#include "base/mapped.h"
#include "base/text.h"
#include "compile/inputs.h"
#include "compile/shader.h"
#include "cpu/texture_store.h"
#include "editor/model/document/folders.h"
#include "editor/model/document/inputs.h"
#include "editor/model/words.h"
#include "editor/model/worker.h"
#include "lower/material.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

// "weave: the image is not there", "scan.obj: the mesh has no uvs (set 0)"
std::string blamed(const Diagnostic& problem) {
    const std::string file = fs::path(problem.where.file).filename().string();
    const std::string& name = problem.node.empty() ? file : problem.node;
    return (name.empty() ? "" : name + ": ") + problem.message;
}

std::string first_blamed(const Diagnostics& problems) {
    for (const Diagnostic& problem : problems.list())
        if (problem.severity == Severity::error) return blamed(problem);
    return {};
}

std::string time_taken(Clock::time_point begun) {
    const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    if (seconds >= 10) return rough_duration(seconds);
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", seconds);
    return text;
}

class MapBaker {
public:
    MapBaker(const BakeJob& job, const Registry& registry, TaskProgress& progress)
        : job_(job), choices_(job.choices), registry_(registry), progress_(progress) {}

    TaskOutcome run() {
        const Clock::time_point begun = Clock::now();
        std::string why;
        asked_ = asked_maps(choices_, why);
        if (!why.empty()) return {false, "No map can be baked. " + why};
        if (!compile() || !read_mesh()) return refused();
        NewPaths folders;
        folders.add_missing(choices_.one_file() ? choices_.into.parent_path() : choices_.into);
        if (!bake_squares() || !finish()) {
            written_.clear();  // closes the files before their folder is removed
            return refused();
        }
        folders.keep();
        return {true, said(begun), warnings()};
    }

private:
    TaskOutcome refused() const {
        if (progress_.cancelled) return {};
        if (!disk_.has_errors())
            return {false, "No map can be baked. " + sentence(first_blamed(problems_))};
        return {false,
                "The maps were not written: " + disk_words(disk_.list().front().message) + "."};
    }

    bool compile() {
        const Project project = project_to_compile(job_.model, job_.document, problems_);
        if (problems_.has_errors()) return false;
        for (InputFile& input : inputs_of(project, Types(project, registry_)))
            read_.push_back(std::move(input.path));
        MaterialOptions options;
        options.given_differentials = true;
        options.covariances = covariances_for(requests());
        options.runs_calls = "the bake";
        compiled_ = compile_material(project, registry_, options, problems_);
        if (compiled_.ok) read_textures(textures_, compiled_, project, problems_);
        return !problems_.has_errors() && !progress_.cancelled;
    }

    bool read_mesh() {
        auto mesh = make_shape(choices_.mesh);
        if (!mesh) {
            mesh = load_mesh(choices_.mesh, {}, problems_);
            read_.push_back(choices_.mesh);
        }
        if (!mesh || !has_uv_layout(*mesh, choices_.mesh, problems_)) return false;
        mesh_ = std::move(*mesh);
        uvs_ = survey_uvs(mesh_);
        if (check_uvs(uvs_, choices_.udim, choices_.mesh, found_)) return plan();
        problems_.append(found_);
        return false;
    }

    std::vector<MapRequest> requests() const {
        return mapped<MapRequest>(asked_, &AskedMap::request);
    }

    bool plan() {
        for (const AskedMap& map : asked_)
            types_.push_back(map.stored->type);
        MapOptions options;
        options.tangent_space = !choices_.object_space;
        options.vertex_tangents = !mesh_.tangents.empty();
        options.green_down = choices_.green_down;
        options.scale = choices_.tuning.scale;
        options.width = choices_.width;
        options.height = choices_.height();
        Diagnostics planned;
        plan_ = plan_maps(compiled_.module, requests(), options, planned);
        (plan_ ? found_ : problems_).append(planned);
        return plan_ && check_inputs(mesh_, {&*plan_, 1}, choices_.mesh, problems_) &&
               !progress_.cancelled;
    }

    bool bake_squares() {
        const std::vector<glm::ivec2> one = {uvs_.square};
        const std::vector<glm::ivec2>& squares = choices_.udim ? uvs_.udim_tiles : one;
        std::vector<std::string> made;
        for (const glm::ivec2 square : squares)
            for (const fs::path& path : baked_files(choices_, suffix_of(square)))
                made.push_back(path.string());
        if (const std::string why = overwrite_fault(made, read_); !why.empty()) {
            problems_.error(RuleId::output_path, why);
            return false;
        }
        progress_.begin(uint64_t{choices_.width} * choices_.height() * squares.size());
        return std::ranges::all_of(squares, [&](glm::ivec2 square) { return bake(square); });
    }

    std::string suffix_of(glm::ivec2 square) const {
        return choices_.udim ? "." + std::to_string(udim_number(square)) : std::string();
    }

    bool bake(glm::ivec2 square) {
        std::vector<MapFile> files;
        for (const fs::path& path : baked_files(choices_, suffix_of(square))) {
            const size_t map = files.size();
            const StoredAs& stored = *asked_[map].stored;
            WriterOptions options = writer_options(plan_->maps[map], stored.type, choices_.width,
                                                   choices_.height(), choices_.tuning.scale);
            options.compression = choices_.compression_in(stored);
            options.tile = choices_.tile_in(stored);
            files.push_back({path, std::move(options)});
        }
        auto writers = open_maps(files, disk_);
        if (!writers) return false;
        written_.push_back(std::move(*writers));
        const std::vector<Texture> textures = textures_.textures_of(plan_->resources);
        TextureSetInput input;
        input.mesh = &mesh_;
        input.plan = &*plan_;
        input.textures = textures;
        input.types = types_;
        input.layout = {choices_.width, choices_.height(), square, choices_.tuning.samples};
        input.dilate = choices_.tuning.dilate;
        BakeSinks take;
        take.rows = [&](size_t map, std::span<const std::byte> rows) {
            return written_.back()[map].write_stored(rows, disk_);
        };
        take.band = [&](uint32_t, uint64_t texels) {
            progress_.done += texels;
            return !progress_.cancelled;
        };
        return bake_texture_set(input, 0, choices_.height(), take, report_);
    }

    bool finish() {
        if (progress_.cancelled) return false;
        return std::ranges::all_of(written_,
                                   [&](auto& files) { return finish_maps(files, disk_); });
    }

    Diagnostics warnings() const {
        Diagnostics all = found_;
        report_.append_warnings(job_.graph, choices_.mesh, plan_->maps, all);
        Diagnostics named;
        for (Diagnostic problem : all.list()) {
            problem.message = blamed(problem);
            named.add(std::move(problem));
        }
        return named;
    }

    std::string said(Clock::time_point begun) const {
        const size_t count = written_.size() * asked_.size();
        const std::string place = choices_.into.filename().string();
        return "Baked " + (choices_.one_file() ? place : counted(count, "map") + " into " + place) +
               " in " + time_taken(begun) + ".";
    }

    const BakeJob& job_;
    const BakeChoices& choices_;
    const Registry& registry_;
    TaskProgress& progress_;
    Diagnostics problems_, disk_, found_;  // fatal; write errors; warnings
    Compiled compiled_;
    TextureStore textures_;
    Mesh mesh_;
    UvSurvey uvs_;
    std::optional<BakePlan> plan_;
    std::vector<AskedMap> asked_;
    std::vector<PixelType> types_;  // by map
    // By UDIM tile and map; temporary files until all are complete.
    std::vector<std::vector<ImageWriter>> written_;
    BakeReport report_;
    std::vector<std::string> read_;  // the files that the maps must not replace
};

}  // namespace

TaskOutcome bake_maps(const BakeJob& job, const Registry& registry, TaskProgress& progress) {
    yield_to_interface();  // also applies to threads started from here
    try {
        return MapBaker(job, registry, progress).run();
    } catch (...) {
        return {false, "No map can be baked: " + exception_text() + "."};
    }
}

void start_bake(Session& session, const BakeChoices& choices) {
    session.keeping.settings.bake = settings_of(choices);
    BakeJob job{session.model,
                with_preset_as_defaults(session.model, session.document(), choices.preset),
                session.path.string(), choices};
    job.choices.into = output_folder(session, choices);
    const auto work = [job = std::move(job), registry = session.registry](TaskProgress& progress) {
        return bake_maps(job, *registry, progress);
    };
    std::string ignored;
    const size_t count = asked_maps(choices, ignored).size();
    start_task(session, {"Baking " + counted(count, "map"), work,
                         [&session, choices] { start_bake(session, choices); }, "texels"});
}

fs::path output_folder(const Session& session, const BakeChoices& choices) {
    return session.folder() / with_home(choices.into);
}

std::vector<std::string> maps_of(const Document& document) {
    return map_names(mapped<std::string>(document.outputs, &Output::name));
}

BakeChoices usual_bake(const Session& session, const std::string& mesh) {
    BakeChoices choices = choices_of(session.keeping.settings.bake);
    const std::vector<std::string> all = maps_of(session.document());
    std::vector<std::string> maps;
    for (const std::string& map : all)
        if (std::ranges::find(choices.maps, map) != choices.maps.end()) maps.push_back(map);
    if (maps.empty() && choices.packs.empty() && !all.empty()) maps.push_back(all.front());
    choices.maps = std::move(maps);
    choices.mesh = mesh;
    choices.into = fs::path(session.file_name()).stem().string() + "_maps";
    return choices;
}

std::string_view no_maps(const Session& session) {
    return session.document().outputs.empty() ? "The graph has no output to bake." : "";
}

}  // namespace wrinkle::editor
