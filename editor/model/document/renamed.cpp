#include "editor/model/document/renamed.h"

#include <map>

#include "graph/edit.h"
#include "graph/renamed.h"

namespace wrinkle::editor {

std::string input_name_problem(const Document& document, const std::string& input,
                               const std::string& name) {
    if (name.empty()) return "Type a name for the input.";
    if (document.inputs.find(name)) return "There is an input " + name + " already.";
    if (const std::string problem = id_problem(name, false); !problem.empty())
        return "\"" + name + "\" cannot be the name of an input: it " + problem + ".";
    const std::string owner(FormerNames(document.inputs).current(name));
    if (!owner.empty() && owner != input)
        return name + " is a former name of " + owner + ", which other files may use.";
    return {};
}

void rename_input(Session& session, const std::string& input, const std::string& name) {
    const Table<GraphInput>* saved = session.history.inputs_at(session.saved_serial);
    session.commit(
        "Rename input " + input + " to " + name,
        rename_graph_input(session.document(), input, name, !saved || saved->find(input)));
}

void use_current_names(Session& session) {
    const Project& project = *session.model.project;
    std::map<std::string_view, FormerNames> names;  // by type of the node
    for (size_t i = 0; i < project.top().nodes.size(); ++i) {
        const uint32_t file = project.files[0].subgraphs[i];
        const std::string_view type = project.top().nodes[i]->type;
        if (file != Project::File::none && !names.contains(type))
            names.emplace(type, FormerNames(project.files[file].document.inputs));
    }
    std::erase_if(names, [](const auto& entry) { return entry.second.empty(); });
    if (names.empty()) return;
    session.history.replace_nodes([&](const NodePtr& node) {
        const auto found = names.find(node->type);
        return found == names.end() ? node : with_current_names(node, found->second);
    });
}

}  // namespace wrinkle::editor
