#include "compile/shader.h"

#include "cost/limits.h"
#include "lower/check.h"
#include "spirv/spirv.h"

namespace wrinkle {

Form default_form(const Target& target) {
    return is_translated(target) ? Form::shader : Form::function;
}

std::string form_conflict(const Target& target, Form form, Differentials differentials) {
    if (form == Form::function && is_translated(target))
        return "the target '" + std::string(target.name) + "' is written as a complete pair";
    if (form == Form::shader && differentials == Differentials::given)
        return "the shader form takes its differentials from the screen";
    return {};
}

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

void check_limits(const Reflection& reflection, const std::string& file, bool strict,
                  Diagnostics& diagnostics) {
    for (const Excess& excess : {texture_unit_excess(reflection), draw_buffer_excess(reflection)}) {
        if (excess.problem.empty()) continue;
        Diagnostic found;
        found.severity = strict ? Severity::error : Severity::warning;
        found.where.file = file;
        found.message = excess.problem;
        found.expected = excess.remedy;
        diagnostics.add(found);
    }
}

MadeShader make_shader(const Project& project, const Registry& registry, ShaderOptions options,
                       Diagnostics& diagnostics) {
    MadeShader made;
    options.material.given_differentials = options.emit.differentials == Differentials::given;
    made.compiled = compile_or_check(project, registry, options.material, diagnostics);
    if (!made.compiled.ok) return made;
    made.shader = write_shader(made.compiled.module, options.emit);
    report_emit(made.shader, made.compiled, project, diagnostics);
    check_limits(made.shader.reflection, project.top().file, options.strict, diagnostics);
    return made;
}

}  // namespace wrinkle
