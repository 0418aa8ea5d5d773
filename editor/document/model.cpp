#include "editor/document/model.h"

#include <map>

#include "editor/document/wiring.h"
#include "editor/words.h"
#include "graph/edit.h"
#include "graph/order.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

std::string refusal(const Link& from, PortType given, std::string_view to, PortType wanted,
                    const Registry& registry) {
    return from.text() + " cannot feed " + std::string(to) + ": a " + std::string(name_of(given)) +
           " is not a " + std::string(name_of(wanted)) + ". " +
           sentence(alternative(given, wanted, registry));
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
    std::map<std::string, uint32_t> files;  // of the sub-graphs, by what nodes call them
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

Project project_to_compile(const Model& model, const Document& document, Diagnostics& problems) {
    check_links(document, problems);
    problems.append(model.project_problems);
    return project_with(model, document);
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
