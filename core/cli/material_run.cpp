#include "cli/material_run.h"

namespace wrinkle::cli {

void compile_runs(ReadGraph graph, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, MaterialOptions options, const UseRun& use,
                  Diagnostics& diagnostics) {
    Diagnostics& own = graph.problems;
    options.vertex_tangents = !common.no_tangents;
    for (size_t i = 0; i == 0 || (i < overrides.runs && !own.has_errors()); ++i) {
        MaterialRun run;
        run.project = project_of_run(graph.project, registry, overrides, i, own);
        run.compiled = compile_or_check(run.project, registry, options, own);
        if (run.compiled.ok) use(i, run, own);
    }
    diagnostics.append_once(own);
}

void compile_runs(const std::string& file, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, MaterialOptions options, const UseRun& use,
                  Diagnostics& diagnostics, const std::string& double_sided) {
    ReadGraph graph;
    graph.project = open_project(file, common, graph.problems);
    if (!double_sided.empty())
        follow_double_sided(graph.project.files[0].document, double_sided, graph.problems);
    compile_runs(std::move(graph), common, registry, overrides, options, use, diagnostics);
}

Shader emit_function(const MaterialRun& run, const std::string& name, Diagnostics& diagnostics) {
    EmitOptions options;
    options.name = name;
    const Shader shader = emit(run.compiled.module, options);
    report_emit(shader, run.compiled, run.project, diagnostics);
    return shader;
}

}  // namespace wrinkle::cli
