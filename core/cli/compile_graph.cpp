#include "cli/compile_graph.h"

#include "cli/cache_entry.h"
#include "cli/cost.h"
#include "cli/material_run.h"
#include "cli/output.h"
#include "cli/outputs.h"
#include "spirv/spirv.h"

namespace wrinkle::cli {
namespace {

std::string name_for(const std::string& file, const TextOptions& options) {
    return options.name.empty() ? material_name(file) : options.name;
}

void make_texts(const std::string& file, const Project& project, const Compilation& with,
                CompiledGraph& result) {
    const TextOptions& wanted = with.options;
    MaterialOptions options;
    options.uniform_parameters = wanted.params == "uniform";
    options.given_differentials = wanted.differentials == "given";
    options.vertex_tangents = !with.common.no_tangents;
    const Compiled compiled = compile_or_check(project, with.registry, options, result.diagnostics);
    if (!compiled.ok) return;
    EmitOptions emit_options;
    emit_options.form = form_of(wanted);
    emit_options.differentials =
        options.given_differentials ? Differentials::given : Differentials::screen;
    emit_options.name = name_for(file, wanted);
    emit_options.target = find_target(wanted.target);
    emit_options.set = wanted.set;
    emit_options.first_binding = wanted.first_binding;
    Shader shader = write_shader(compiled.module, emit_options);
    report_emit(shader, compiled, project, result.diagnostics);
    judge_limits(shader.reflection, file, wanted.strict, result.diagnostics);
    if (wanted.cost && !result.diagnostics.has_errors())
        result.cost = cost_of(compiled.module, emit_options.differentials, wanted.json, file,
                              result.diagnostics);
    if (result.diagnostics.has_errors()) return;
    const std::string suffix(emit_options.target->suffix);
    if (emit_options.form == Form::function)
        result.texts.push_back({"", "", std::move(shader.source)});
    else
        result.texts = {{"vertex", vertex_suffix + suffix, std::move(shader.vertex)},
                        {"fragment", fragment_suffix + suffix, std::move(shader.fragment)}};
    result.reflection = to_json(shader.reflection);
}

}  // namespace

Form form_of(const TextOptions& options) {
    const bool pair = options.form.empty() ? is_translated(*find_target(options.target))
                                           : options.form == "shader";
    return pair ? Form::shader : Form::function;
}

CompiledGraph compile_graph(const std::string& file, const Compilation& with) {
    CompiledGraph result;
    const Project read = open_project(file, with.common, result.diagnostics);
    const Project project =
        with_overrides(read, with.registry, with.overrides.list, 0, result.diagnostics);
    std::string key;
    if (!result.diagnostics.has_errors()) {
        const Types types(project, with.registry);
        result.inputs = inputs_of(project, types);
        if (with.cache) key = cache_key(project, types, name_for(file, with.options), with);
        if (!key.empty() && take_entry(*with.cache, key, project, result)) return result;
    }
    make_texts(file, project, with, result);
    if (!key.empty() && !result.texts.empty()) store_entry(*with.cache, key, project, result);
    return result;
}

}  // namespace wrinkle::cli
