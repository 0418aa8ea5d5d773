#include "editor/document/model.h"

#include <chrono>

#include "editor/document/wiring.h"
#include "graph/edit.h"
#include "graph/order.h"
#include "lower/check.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

std::optional<Shader> emit_text(const Project& project, const Registry& registry,
                                const std::string& name, Diagnostics& problems) {
    MaterialOptions options;
    options.uniform_parameters = true;
    options.reached_only = true;
    const Compiled compiled = compile_material(project, registry, options, problems);
    if (!compiled.ok) return std::nullopt;
    EmitOptions emit_options;
    emit_options.name = name;
    Shader shader = emit(compiled.module, emit_options);
    if (shader.problems.empty()) return shader;
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

std::string refusal(const Link& from, PortType given, std::string_view to, PortType wanted,
                    const Registry& registry) {
    return from.text() + " cannot feed " + std::string(to) + ": a " + std::string(name_of(given)) +
           " is not a " + std::string(name_of(wanted)) + "; " +
           alternative(given, wanted, registry);
}

}  // namespace

const NodeType* Model::type_of(std::string_view node) const {
    const size_t index = project->top().nodes.index_of(node);
    return index == Table<NodePtr>::npos ? nullptr : types->of(0, index);
}

std::optional<PortType> Model::type_of(const Link& from) const {
    return types->link(0, from);
}

std::optional<PortType> Model::wanted_by_output(std::string_view name) {
    return standard_output(name);
}

Model make_model(const Document& document, const std::filesystem::path& folder,
                 const Registry& registry) {
    Model model;
    model.project = std::make_shared<const Project>(
        load_project(document, folder, ProjectOptions{}, model.project_problems));
    model.types = std::make_shared<const Types>(*model.project, registry);
    return model;
}

Project project_with(const Model& model, const Document& document) {
    Project project = *model.project;
    project.files[0].document = document;
    return project;
}

Build build(const Model& model, const Document& document, const Registry& registry,
            const std::string& name) {
    const auto start = std::chrono::steady_clock::now();
    Build result;
    const Project project = project_with(model, document);
    Diagnostics links;
    check_links(document, links);
    const bool linked = report_unread(document, result.problems) && !links.has_errors();
    if (!document.edited) result.problems.append(links);  // of an edited one check() says them
    result.problems.append(model.project_problems);
    check(project, registry, result.problems);
    if (linked) result.uniform = emit_text(project, registry, name, result.live);
    if (!result.problems.has_errors()) result.problems.append(result.live);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    result.milliseconds = time.count();
    return result;
}

std::string wire_problem(const Model& model, const Document& document, const Registry& registry,
                         const Link& from, std::string_view node, std::string_view port) {
    const auto given = model.type_of(from);
    const NodeType* type = model.type_of(node);
    if (!given || !type) return "the type of one end is not known";
    if (type->id == reroute_type) {
        for (const Connection& end : fed_by_reroute(document, std::string(node))) {
            const auto wanted = wanted_at(model, end.node, end.port);
            if (!converts(*given, wanted))
                return refusal(from, *given, end.node + "." + end.port, *wanted, registry);
        }
        return {};
    }
    const uint32_t index = type->find_input(port);
    if (index == NodeType::none || !type->ports[index].is_value())
        return std::string(node) + "." + std::string(port) + " takes no wire";
    const PortType wanted = type->ports[index].type;
    if (conversion(*given, wanted) != Conversion::illegal) return {};
    return refusal(from, *given, std::string(node) + "." + std::string(port), wanted, registry);
}

std::string output_problem(const Model& model, const Link& from, std::string_view output,
                           const Registry& registry) {
    const auto given = model.type_of(from);
    if (!given) return "the type of " + from.text() + " is not known";
    const auto wanted = Model::wanted_by_output(output);
    if (!wanted || conversion(*given, *wanted) != Conversion::illegal) return {};
    return refusal(from, *given, std::string(output), *wanted, registry);
}

}  // namespace wrinkle::editor
