#include "editor/model/document/model.h"

#include <algorithm>
#include <map>

#include "graph/edit.h"
#include "graph/order.h"
#include "lower/reachable.h"

namespace wrinkle::editor {
namespace {

// Returns true if the problem comes from reading a file in this part of the project.
bool is_of(const Diagnostic& problem, const Project& part) {
    return std::ranges::any_of(part.files, [&](const Project::File& file) {
        const bool used = &file == part.files.data() || !file.document.file.empty();
        return used && file.document.file == problem.where.file &&
               (problem.node.empty() || file.document.find(problem.node));
    });
}

// A known key among the unknown ones has a value of another form.
void report_unread_keys(const Document& document, const GraphInput& input, Diagnostics& problems) {
    each_key(input, [&](std::string_view key, const auto&) {
        if (std::ranges::find(input.unknown, key, &Extra::key) == input.unknown.end()) return;
        const std::string quoted = "\"" + std::string(key) + "\"";
        problems.add(diagnose_key(document, input, key, RuleId::invalid_value,
                                  "input '" + input.name + "': " + quoted + " could not be read",
                                  "remove it, or give it the form of docs/graph-format.md"));
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

const Port* input_port(const NodeType* type, std::string_view name) {
    const uint32_t index = type ? type->find_input(name) : NodeType::none;
    return index == NodeType::none ? nullptr : &type->ports[index];
}

const Port* output_port(const NodeType* type, std::string_view name) {
    const uint32_t index = type ? type->find_output(name) : NodeType::none;
    return index == NodeType::none ? nullptr : &type->ports[index];
}

const Port* first_output(const NodeType* type, std::initializer_list<PortType> wanted) {
    const auto fits = [&](const Port& port) {
        return port.kind == Port::Kind::output &&
               (wanted.size() == 0 || std::ranges::find(wanted, port.type) != wanted.end());
    };
    if (!type) return nullptr;
    const auto found = std::ranges::find_if(type->ports, fits);
    return found == type->ports.end() ? nullptr : &*found;
}

Model make_model(const Document& document, const std::filesystem::path& folder,
                 const Registry& registry, const std::filesystem::path& root) {
    Model model;
    model.registry = &registry;
    model.project = std::make_shared<const Project>(
        load_project(document, folder, {root, {}}, model.project_problems));
    model.types = std::make_shared<const Types>(*model.project, registry);
    return model;
}

std::optional<NodeType> subgraph_type(const Model& model, const std::string& file,
                                      std::string& why) {
    const Project& project = *model.project;
    Node node;
    node.id = "graph";
    node.type = type_of_subgraph(file);
    Document document;
    document.file = project.top().file;  // so that a cycle of files is found
    const Model probe = make_model(add_node(document, node), project.files[0].path.parent_path(),
                                   *model.registry, project.root);
    const NodeType* type = probe.type_of(node.id);
    if (!type || probe.project_problems.has_errors()) {
        const std::vector<Diagnostic>& problems = probe.project_problems.list();
        why = file + (problems.empty() ? " cannot be used" : ": " + problems.front().message) + ".";
        return std::nullopt;
    }
    NodeType found = *type;
    found.id = node.type;
    return found;
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
                problems.add(diagnose_port(document, *node, input.port, RuleId::invalid_value,
                                           "port '" + input.port + "' could not be read", wanted));
    for (const GraphInput& input : document.inputs)
        report_unread_keys(document, input, problems);
    for (const Output& output : document.outputs)
        if (output.from.kind != Input::Kind::link)
            problems.add(diagnose(document, output, RuleId::invalid_link,
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

}  // namespace wrinkle::editor
