#include "cli/bake_job.h"

#include "bake/mesh_check.h"
#include "base/checksum.h"
#include "base/file.h"
#include "base/mapped.h"
#include "cli/identity.h"
#include "cli/meshes.h"
#include "mesh/uv_survey.h"

namespace wrinkle::cli {
namespace {

std::vector<TextureSet> sets_of(const BakeJob& job, const UvSurvey& uvs,
                                const Overrides& overrides) {
    std::vector<TextureSet> sets;
    const std::vector<glm::ivec2> one = {uvs.square};
    for (size_t run = 0; run < job.plans.size(); ++run)
        for (const glm::ivec2 square : job.options.udim ? uvs.udim_tiles : one) {
            std::string suffix = path_of_run("", overrides, run);
            if (job.options.udim) suffix += "." + std::to_string(udim_number(square));
            sets.push_back({run, square, suffix});
        }
    return sets;
}

template <class T>
std::string sum_of(const std::vector<T>& values) {
    return sha256({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

std::string sum_of(const Mesh& mesh) {
    std::vector<std::string> sums = {sum_of(mesh.positions), sum_of(mesh.normals),
                                     sum_of(mesh.tangents), sum_of(mesh.colors),
                                     sum_of(mesh.indices)};
    for (const auto& uvs : mesh.uvs)
        sums.push_back(sum_of(uvs));
    return sha256(join_fields(sums));
}

// Hash of the program, the mesh, the options and the contents of all input files, which are read
// again.
std::string identity_of(const BakeJob& job) {
    const BakeOptions& o = job.options;
    std::vector<std::string> fields = {
        program_identity(), sum_of(job.mesh), o.size, o.space, o.maps, o.type,
        o.format,           o.compression};
    fields.push_back(join_fields(o.packs));
    fields.push_back(join_fields(o.common.presets));
    fields.push_back(join_fields(o.common.set));
    for (const double number :
         {o.scale, double(o.samples), double(o.dilate), double(o.tile), double(o.dx),
          double(o.udim), double(o.common.no_tangents), double(job.request.one_file)})
        fields.push_back(std::to_string(number));
    for (const std::string& input : job.inputs) {
        std::string why;
        const auto bytes = read_file(input, why);
        fields.push_back(input);
        fields.push_back(bytes ? sha256(*bytes) : why);
    }
    return sha256(join_fields(fields));
}

MapOptions map_options(const BakeOptions& options, const BakeRequest& request, const Mesh& mesh) {
    MapOptions maps;
    maps.tangent_space = options.space == "tangent";
    maps.vertex_tangents = !mesh.tangents.empty();
    maps.green_down = options.dx;
    maps.scale = options.scale;
    maps.width = request.width;
    maps.height = request.height;
    return maps;
}

// Compiles every run of the sweep and plans its maps.
void plan_runs(BakeJob& job, const Overrides& overrides, Diagnostics& diagnostics) {
    const Nodes nodes = load_nodes(job.options.common, diagnostics);
    const auto requests = mapped<MapRequest>(job.request.maps, &WantedMap::request);
    const MapOptions maps = map_options(job.options, job.request, job.mesh);
    const auto use = [&](size_t, const MaterialRun& run, Diagnostics& problems) {
        read_textures(job.textures, run.compiled, run.project, problems);
        Diagnostics own;
        auto plan = plan_maps(run.compiled.module, requests, maps, own);
        for (Diagnostic problem : own.list()) {
            problem.where.file = job.options.file;
            problems.add(std::move(problem));
        }
        if (plan) job.plans.push_back(std::move(*plan));
        if (job.inputs.empty()) job.inputs = input_paths(run.project, nodes.registry);
    };
    const MaterialOptions options{.given_differentials = true,
                                  .covariances = covariances_for(requests),
                                  .runs_calls = "bake"};
    compile_runs(job.options.file, job.options.common, nodes.registry, overrides, options, use,
                 diagnostics);
}

}  // namespace

std::optional<BakeJob> make_bake_job(const BakeOptions& options, const BakeRequest& request,
                                     Diagnostics& diagnostics) {
    BakeJob job;
    job.options = options;
    job.request = request;
    std::vector<std::string> mesh_files;
    auto mesh = open_mesh(options.mesh, options.common, diagnostics, &mesh_files);
    if (mesh) has_uv_layout(*mesh, options.mesh, diagnostics);
    if (mesh) job.mesh = std::move(*mesh);
    const Overrides overrides = parse_overrides(options.common, diagnostics);
    plan_runs(job, overrides, diagnostics);
    if (diagnostics.has_errors()) return {};
    const UvSurvey uvs = survey_uvs(job.mesh);
    if (!check_uvs(uvs, options.udim, options.mesh, diagnostics) ||
        !check_inputs(job.mesh, job.plans, options.mesh, diagnostics))
        return {};
    job.sets = sets_of(job, uvs, overrides);
    if (request.is_shard() || options.resume) job.identity = identity_of(job);
    job.inputs.insert(job.inputs.end(), mesh_files.begin(), mesh_files.end());
    return job;
}

}  // namespace wrinkle::cli
