#include "editor/model/document/model.h"

#include <algorithm>
#include <map>

#include "editor/model/document/wiring.h"
#include "editor/model/words.h"
#include "graph/edit.h"
#include "graph/order.h"
#include "lower/conversion.h"
#include "lower/reachable.h"

namespace wrinkle::editor {
namespace {

std::string refusal(const Link& from, PortType given, std::string_view to, PortType wanted,
                    const Registry& registry) {
    return from.text() + " cannot feed " + std::string(to) + ": a " + std::string(name_of(given)) +
           " is not a " + std::string(name_of(wanted)) + ". " +
           sentence(alternative(given, wanted, registry));
}

// Returns true if the problem comes from reading a file in this part of the project.
bool is_of(const Diagnostic& problem, const Project& part) {
    return std::any_of(part.files.begin(), part.files.end(), [&](const Project::File& file) {
        const bool used = &file == part.files.data() || !file.document.file.empty();
        return used && file.document.file == problem.where.file &&
               (problem.node.empty() || file.document.find(problem.node));
    });
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
                 const Registry& registry, const std::filesystem::path& root) {
    Model model;
    model.project = std::make_shared<const Project>(
        load_project(document, folder, {root, {}}, model.project_problems));
    model.types = std::make_shared<const Types>(*model.project, registry);
    return model;
}

Project project_with(const Model& model, const Document& document) {
    Project project = *model.project;
    Project::File& top = project.files[0];
    std::map<std::string, uint32_t> files;  // indices of the sub-graphs' files, by node type
    for (size_t i = 0; i < top.document.nodes.size(); ++i)
        files[top.document.nodes[i]->type] = top.subgraphs[i];
    top.subgraphs.clear();
    for (const NodePtr& node : document.nodes) {
        const auto file = files.find(node->type);
        top.subgraphs.push_back(file == files.end() ? Project::File::none : file->second);
    }
    top.document = document;
    return project;
}

void report_unread(const Document& document, Diagnostics& problems) {
    const std::string wanted = R"(expected a value, or {"from": "node.port"})";
    for (const NodePtr& node : document.nodes)
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::broken)
                problems.add(diagnose_port(document, *node, input.port,
                                           "port '" + input.port + "' could not be read", wanted));
    for (const Output& output : document.outputs)
        if (output.from.kind != Input::Kind::link)
            problems.add(diagnose(document, output,
                                  "output '" + output.name + "' could not be read",
                                  R"(expected {"from": "node.port"})"));
}

Project project_to_compile(const Model& model, const Document& document, Diagnostics& problems) {
    Project project = reached_part(project_with(model, document));
    report_unread(project.top(), problems);
    check_links(project.top(), problems);
    for (const Diagnostic& problem : model.project_problems.list())
        if (is_of(problem, project)) problems.add(problem);
    return project;
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
