#include "cli/material_run.h"

#include <array>

namespace wrinkle::cli {
namespace {

constexpr std::array<const char*, 4> purpose_names = {"eval", "render", "bake", "bake"};

}  // namespace

void compile_runs(const std::string& file, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, Purpose purpose, const UseRun& use,
                  Diagnostics& diagnostics, const std::string& double_sided) {
    Diagnostics own;
    Project project = open_project(file, common, own);
    if (!double_sided.empty()) follow_double_sided(project.files[0].document, double_sided, own);
    MaterialOptions options;
    options.given_differentials = purpose != Purpose::render;
    if (purpose == Purpose::bake_moments) options.covariances = Covariances::kept;
    options.vertex_tangents = !common.no_tangents;
    options.runs_calls = purpose_names[static_cast<size_t>(purpose)];
    for (size_t i = 0; i == 0 || (i < overrides.runs && !own.has_errors()); ++i) {
        MaterialRun run;
        run.project = with_overrides(project, registry, overrides.list, i, own);
        run.compiled = compile_or_check(run.project, registry, options, own);
        if (run.compiled.ok) use(i, run, own);
    }
    diagnostics.append_once(own);
}

Shader emit_function(const MaterialRun& run, const std::string& name, Diagnostics& diagnostics) {
    EmitOptions options;
    options.name = name;
    const Shader shader = emit(run.compiled.module, options);
    report_emit(shader, run.compiled, run.project, diagnostics);
    return shader;
}

}  // namespace wrinkle::cli
