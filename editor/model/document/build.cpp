#include "editor/model/document/build.h"

#include <chrono>
#include <set>

#include "compile/shader.h"
#include "editor/model/document/inputs.h"
#include "editor/model/words.h"
#include "graph/edit.h"
#include "graph/order.h"
#include "lower/check.h"
#include "lower/material.h"

namespace wrinkle::editor {
namespace {

std::optional<Shader> emit_text(const Project& project, const Registry& registry,
                                const std::string& name, Diagnostics& problems,
                                std::shared_ptr<const Module>* module = nullptr) {
    MaterialOptions options;
    options.uniform_parameters = true;
    options.runs_calls = "the preview";
    Compiled compiled = compile_material(project, registry, options, problems);
    if (!compiled.ok) return std::nullopt;
    EmitOptions emit_options;
    emit_options.name = name;
    Shader shader = emit(compiled.module, emit_options);
    if (shader.problems.empty()) {
        if (module) *module = std::make_shared<const Module>(std::move(compiled.module));
        return shader;
    }
    report_problems(shader.problems, compiled.module, project, compiled.places, problems);
    return std::nullopt;
}

void report_lost(const Document& document, Diagnostics& problems) {
    if (!document.lost.empty())
        problems.add(diagnose(document, RuleId::file_unreadable,
                              "not all of the file could be read: " + document.lost,
                              "it is not written over; save under another name"));
}

// Appends the problems that are not in the list yet.
void append_new(Diagnostics& problems, const Diagnostics& more) {
    std::set<std::string> known;
    for (const Diagnostic& problem : problems.list())
        known.insert(to_text(problem));
    for (const Diagnostic& problem : more.list())
        if (known.insert(to_text(problem)).second) problems.add(problem);
}

void build_shown(const Model& model, const Document& document, const std::string& name,
                 Build& result) {
    const PreviewRequest& request = result.request;
    if (request.node.empty() && request.against == Against::nothing) return;
    Requested requested = requested_document(document, model, request);
    result.why_not_shown = requested.why_not;
    if (!requested.why_not.empty()) return;
    Diagnostics problems;
    const Project project = project_to_compile(model, requested.document, problems);
    result.shown = emit_text(project, *model.registry, name, problems);
    if (!result.shown) result.why_not_shown = first_error(problems);
    result.copied = std::move(requested.copied);
    result.replaced = requested.replaced;
}

// An empty graph is shown as the bare mesh.
void build_bare(const Model& model, const Document& document, const std::string& name,
                Build& result) {
    Diagnostics problems;
    const Document bare = set_output(document, "normal", {std::string(Link::surface), "normal"});
    const Project project = project_to_compile(model, bare, problems);
    result.shown = emit_text(project, *model.registry, name, problems);
}

void build_displacement(const Project& project, const Registry& registry, Build& result) {
    if (!result.request.displaced || !project.top().find_output("displacement")) return;
    MaterialOptions options;
    options.given_differentials = true;
    options.runs_calls = "the displacement";
    options.lower.outputs = {"displacement"};
    Diagnostics problems;
    const Compiled compiled = compile_material(project, registry, options, problems);
    if (!compiled.ok) return;
    std::string why;
    Displacement displacement{compile_program(compiled.module, why), compiled.module.resources};
    if (why.empty())
        result.displacement = std::make_shared<const Displacement>(std::move(displacement));
}

}  // namespace

bool holds_nothing(const Document& document) {
    return document.nodes.empty() && document.outputs.empty();
}

Build build(const CompileJob& job) {
    const auto start = std::chrono::steady_clock::now();
    const Model& model = job.model;
    const Document& document = job.document;
    const Registry& registry = *model.registry;
    const std::string& double_sided = job.request.double_sided;
    Build result;
    result.version = job.version;
    result.document = document;
    result.request = job.request;
    const Project project = project_with(model, document);
    Diagnostics links;
    check_links(document, links);
    report_lost(document, result.problems);
    report_unread(document, result.problems);
    if (!document.edited) result.problems.append(links);  // check() reports those of edited ones
    result.problems.append(model.project_problems);
    if (!holds_nothing(document))
        check(project, registry, Types(project, registry), result.problems);
    Document drawn = with_preset_as_defaults(model, document, job.request.preset);
    if (!double_sided.empty() && !holds_nothing(document))
        follow_double_sided(drawn, double_sided, result.problems);
    const Project needed = project_to_compile(model, drawn, result.live);
    if (!result.live.has_errors()) {
        // Without outputs check() has reported that nothing is made.
        if (!document.outputs.empty())
            result.uniform = emit_text(needed, registry, job.name, result.live, &result.module);
        if (result.uniform) result.costs = estimate_costs(*result.module, document);
        append_new(result.problems, result.live);
        build_displacement(needed, registry, result);
    }
    if (holds_nothing(document))
        build_bare(model, drawn, job.name, result);
    else
        build_shown(model, drawn, job.name, result);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    result.milliseconds = time.count();
    return result;
}

}  // namespace wrinkle::editor
