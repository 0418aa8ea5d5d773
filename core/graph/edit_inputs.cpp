// Edits of a graph's inputs with everything that names them.
#include <algorithm>

#include "graph/condition.h"
#include "graph/edit.h"
#include "graph/edit_parts.h"
#include "graph/renamed.h"

namespace wrinkle {
namespace {

// Calls visit(node, port) for each port that reads the input; node "" for an output of the graph.
template <class Visit>
void each_reader(const Document& document, const Link& input, Visit visit) {
    const auto reads = [&](const Input& port) {
        return port.kind == Input::Kind::link && port.link == input;
    };
    for (const NodePtr& node : document.nodes)
        for (const Input& port : node->inputs)
            if (reads(port)) visit(node->id, port.port);
    for (const Output& output : document.outputs)
        if (reads(output.from)) visit(std::string(), output.name);
}

// Returns the presets with `change` applied to each list of values; it returns true for a change.
template <class Change>
Document change_presets(Document document, Change change) {
    for (const Preset& preset : Table<Preset>(document.presets)) {
        Preset copy = preset;
        if (change(copy.values)) document = set_preset(document, std::move(copy));
    }
    return document;
}

// Replaces the input's name in the conditions of the others; a condition on "" is removed.
Document change_conditions(Document document, std::string_view name, std::string_view new_name) {
    for (const GraphInput& input : Table<GraphInput>(document.inputs)) {
        const auto condition = parse_condition(input.when);
        if (!condition || condition->input != name) continue;
        GraphInput copy = input;
        const std::string old = Link{std::string(Link::input), std::string(name)}.text();
        copy.when = new_name.empty() ? ""
                                     : copy.when.replace(copy.when.find(old), old.size(),
                                                         "input." + std::string(new_name));
        document = set_graph_input(document, std::move(copy));
    }
    return document;
}

// Returns the former names of an input that is called `new_name` from now on.
json::Value former_names(const GraphInput& input, std::string_view new_name, bool is_known) {
    std::vector<json::Value> names;
    for (const json::Member& former : input.renamed.children())
        if (former.value.as_string() != new_name) names.push_back(former.value);
    if (is_known) names.push_back(json::Value::string(input.name));
    return names.empty() ? json::Value() : json::Value::array(names);
}

}  // namespace

Document rename_graph_input(const Document& document, std::string_view name,
                            std::string_view new_name, bool is_known) {
    const size_t index = document.inputs.index_of(name);
    const std::string_view owner = FormerNames(document.inputs).current(new_name);
    if (index == Table<GraphInput>::npos || !id_problem(new_name, false).empty() ||
        document.inputs.find(new_name) || (!owner.empty() && owner != name))
        return document;
    Document changed = document;
    std::vector<GraphInput> inputs(document.inputs.begin(), document.inputs.end());
    inputs[index].renamed = former_names(inputs[index], new_name, is_known);
    inputs[index].name = new_name;
    changed.inputs = Table<GraphInput>(std::move(inputs));
    const Link from{std::string(Link::input), std::string(new_name)};
    each_reader(document, {from.node, std::string(name)},
                [&](const std::string& node, const std::string& port) {
                    changed = node.empty() ? set_output(changed, port, from)
                                           : connect(changed, from, node, port);
                });
    changed = change_presets(std::move(changed), [&](std::vector<Extra>& values) {
        const auto value = std::ranges::find(values, name, &Extra::key);
        if (value == values.end()) return false;
        value->key = new_name;
        return true;
    });
    changed = change_conditions(std::move(changed), name, new_name);
    editing::mark_edited(changed);
    return changed;
}

Document remove_graph_input(const Document& document, std::string_view name) {
    if (!document.inputs.find(name)) return document;
    Document changed = document;
    each_reader(document, {std::string(Link::input), std::string(name)},
                [&](const std::string& node, const std::string& port) {
                    changed = node.empty() ? remove_output(changed, port)
                                           : disconnect(changed, node, port);
                });
    changed = change_presets(std::move(changed), [&](std::vector<Extra>& values) {
        return std::erase_if(values, [&](const Extra& value) { return value.key == name; }) > 0;
    });
    changed = change_conditions(std::move(changed), name, "");
    changed.inputs = changed.inputs.without(name);
    editing::mark_edited(changed);
    return changed;
}

}  // namespace wrinkle
