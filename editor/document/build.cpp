#include "editor/document/build.h"

#include <chrono>

#include "editor/words.h"
#include "graph/order.h"
#include "lower/check.h"
#include "lower/material.h"

namespace wrinkle::editor {
namespace {

std::optional<Shader> emit_text(const Project& project, const Registry& registry,
                                const std::string& name, Diagnostics& problems,
                                Build* result = nullptr) {
    MaterialOptions options;
    options.uniform_parameters = true;
    options.reached_only = true;
    options.runs_calls = "the preview";
    Compiled compiled = compile_material(project, registry, options, problems);
    if (!compiled.ok) return std::nullopt;
    EmitOptions emit_options;
    emit_options.name = name;
    Shader shader = emit(compiled.module, emit_options);
    if (shader.problems.empty()) {
        if (result) {
            result->costs = estimate_costs(compiled.module, project.top());
            result->module = std::make_shared<const Module>(std::move(compiled.module));
        }
        return shader;
    }
    report_problems(shader.problems, compiled.module, project, compiled.places, problems);
    return std::nullopt;
}

// What reading a text could not use: check() takes it as reported, and nothing can be made of it.
// False when something stands where a wire or a value should.
bool report_unread(const Document& document, Diagnostics& problems) {
    if (!document.lost.empty())
        problems.add(diagnose(document, "not all of the file could be read: " + document.lost,
                              "it is not written over; save under another name"));
    bool whole = true;
    const auto broken = [&](Diagnostic problem) {
        problems.add(std::move(problem));
        whole = false;
    };
    const std::string wanted = R"(expected a value, or {"from": "node.port"})";
    for (const NodePtr& node : document.nodes)
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::broken)
                broken(diagnose_port(document, *node, input.port,
                                     "port '" + input.port + "' could not be read", wanted));
    for (const Output& output : document.outputs)
        if (output.from.kind != Input::Kind::link)
            broken(diagnose(document, output, "output '" + output.name + "' could not be read",
                            R"(expected {"from": "node.port"})"));
    return whole;
}

void build_shown(const Model& model, const Document& document, const Registry& registry,
                 const std::string& name, Build& result) {
    const PreviewRequest& request = result.request;
    if (request.node.empty() && request.against == Against::nothing) return;
    Requested requested = requested_document(document, model, request);
    result.why_not_shown = requested.why_not;
    if (!requested.why_not.empty()) return;
    Diagnostics problems;
    const Project project = project_with(model, requested.document);
    result.shown = emit_text(project, registry, name, problems);
    if (!result.shown) result.why_not_shown = first_error(problems);
    result.copied = std::move(requested.copied);
    result.replaced = requested.replaced;
}

void build_displacement(const Project& project, const Registry& registry, Build& result) {
    if (!result.request.displaced || !project.top().outputs.find("displacement")) return;
    MaterialOptions options;
    options.given_differentials = true;
    options.reached_only = true;
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

Build build(const Model& model, const Document& document, const Registry& registry,
            const std::string& name, const PreviewRequest& request) {
    const auto start = std::chrono::steady_clock::now();
    Build result;
    result.request = request;
    const Project project = project_with(model, document);
    Diagnostics links;
    check_links(document, links);
    const bool linked = report_unread(document, result.problems) && !links.has_errors();
    if (!document.edited) result.problems.append(links);  // of an edited one check() says them
    result.problems.append(model.project_problems);
    if (!holds_nothing(document)) check(project, registry, result.problems);
    if (linked) {
        // Without outputs check() has said that nothing is made.
        if (!document.outputs.empty())
            result.uniform = emit_text(project, registry, name, result.live, &result);
        build_shown(model, document, registry, name, result);
        build_displacement(project, registry, result);
    }
    if (!result.problems.has_errors()) result.problems.append(result.live);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    result.milliseconds = time.count();
    return result;
}

}  // namespace wrinkle::editor
