#include "cli/material_run.h"

#include <filesystem>

#include "base/text.h"
#include "cli/output.h"
#include "lower/check.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;

Compiled compile_or_check(const Project& project, const Registry& registry,
                          const MaterialOptions& options, Diagnostics& diagnostics) {
    if (!diagnostics.has_errors()) return compile_material(project, registry, options, diagnostics);
    check(project, registry, diagnostics);
    return {};
}

void report_emit(const Shader& shader, const Compiled& compiled, const Project& project,
                 Diagnostics& diagnostics) {
    report_problems(shader.problems, compiled.module, project, compiled.places, diagnostics);
}

void compile_runs(const std::string& file, const CommonOptions& common, const Registry& registry,
                  const Overrides& overrides, bool given_differentials, const UseRun& use,
                  Diagnostics& diagnostics) {
    Diagnostics own;
    const Project project = open_project(file, common, own);
    MaterialOptions options;
    options.given_differentials = given_differentials;
    options.vertex_tangents = !common.no_tangents;
    options.runs_calls = given_differentials ? "eval" : "render";
    for (size_t i = 0; i == 0 || (i < overrides.runs && !own.has_errors()); ++i) {
        MaterialRun run;
        run.project = with_overrides(project, registry, overrides.list, i, own);
        run.compiled = compile_or_check(run.project, registry, options, own);
        if (run.compiled.ok) use(i, run, own);
    }
    append_once(own, diagnostics);
}

Shader emit_function(const MaterialRun& run, const std::string& name, Diagnostics& diagnostics) {
    EmitOptions options;
    options.name = name;
    const Shader shader = emit(run.compiled.module, options);
    report_emit(shader, run.compiled, run.project, diagnostics);
    return shader;
}

}  // namespace wrinkle::cli
