#include "cli/material_run.h"

#include "graph/document.h"
#include "lower/check.h"

namespace wrinkle::cli {

std::vector<MaterialRun> compile_runs(const std::string& file, const CommonOptions& common,
                                      const Registry& registry, const Overrides& overrides,
                                      bool given_differentials, Diagnostics& diagnostics) {
    Diagnostics own;
    const Project project = open_project(file, common, own);
    for (const Project::File& each : project.files)
        report_unknown(each.document, own);
    MaterialOptions options;
    options.given_differentials = given_differentials;
    options.vertex_tangents = !common.no_tangents;
    std::vector<MaterialRun> runs;
    for (size_t run = 0; run < overrides.runs && !own.has_errors(); ++run) {
        Project changed = with_overrides(project, registry, overrides.list, run, own);
        Compiled compiled = compile_material(changed, registry, options, own);
        runs.push_back({std::move(changed), std::move(compiled)});
    }
    if (own.has_errors() && runs.empty()) check(project, registry, own);
    diagnostics.append(own);
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
