#include "cli/material_run.h"

#include "cli/output.h"

namespace wrinkle::cli {

std::vector<MaterialRun> compile_runs(const std::string& file, const CommonOptions& common,
                                      const Registry& registry, const Overrides& overrides,
                                      bool given_differentials, Diagnostics& diagnostics) {
    Diagnostics own;
    const Project project = open_project(file, common, own);
    MaterialOptions options;
    options.given_differentials = given_differentials;
    options.vertex_tangents = !common.no_tangents;
    std::vector<MaterialRun> runs;
    do {
        Project changed = with_overrides(project, registry, overrides.list, runs.size(), own);
        Compiled compiled = compile_or_check(changed, registry, options, own);
        runs.push_back({std::move(changed), std::move(compiled)});
    } while (runs.size() < overrides.runs && !own.has_errors());
    append_once(own, diagnostics);
    return runs;
}

Shader emit_function(const MaterialRun& run, const std::string& name, Diagnostics& diagnostics) {
    EmitOptions options;
    options.name = name;
    const Shader shader = emit(run.compiled.module, options);
    report_emit(shader, run.compiled, run.project, diagnostics);
    return shader;
}

}  // namespace wrinkle::cli
