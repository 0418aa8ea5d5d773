#include "editor/model/document/wiring.h"
#include "editor/model/words.h"
#include "editor/view/edit/edits.h"
#include "graph/edit.h"

namespace wrinkle::editor {

std::vector<std::string> copy_targets(const State& state, const PortOfNode& value) {
    const Document& document = state.document();
    const Node* from = document.find(value.node);
    if (!from || !value.port || link_at(document, value.node, value.port->name)) return {};
    std::vector<std::string> found;
    for (const std::string& id : state.view.selected) {
        const Node* node = document.find(id);
        if (node && node != from && node->type == from->type &&
            !link_at(document, id, value.port->name))
            found.push_back(id);
    }
    return found;
}

void copy_value(State& state, const PortOfNode& value) {
    const Input* input = state.document().find(value.node)->find(value.port->name);
    const std::vector<std::string> ids = copy_targets(state, value);
    Document document = state.document();
    for (const std::string& id : ids)
        document = input ? set_value(document, id, value.port->name, input->value)
                         : reset_value(document, id, value.port->name);
    state.commit("Copy " + value.port->name + " to " + counted(ids.size(), "node"),
                 std::move(document));
}

std::string_view no_copied_value(const State& state) {
    const PortOfNode value = pointed_port(state);
    if (!value.port) return "Point at a value.";
    return copy_targets(state, value).empty() ? "Select other nodes of that type." : "";
}

void copy_pointed_value(State& state) {
    copy_value(state, pointed_port(state));
}

}  // namespace wrinkle::editor
