#include "cli/material_run.h"

namespace wrinkle::cli {

void compile_runs(const std::string& file, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, MaterialOptions options, const UseRun& use,
                  Diagnostics& diagnostics, const std::string& double_sided) {
    Diagnostics own;
    Project project = open_project(file, common, own);
    if (!double_sided.empty()) follow_double_sided(project.files[0].document, double_sided, own);
    options.vertex_tangents = !common.no_tangents;
    for (size_t i = 0; i == 0 || (i < overrides.runs && !own.has_errors()); ++i) {
        MaterialRun run;
        run.project = project_of_run(project, registry, overrides, i, own);
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
