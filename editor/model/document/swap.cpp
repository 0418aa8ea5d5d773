// Swaps the values or wires at two inputs of a node.
#include <algorithm>

#include "editor/model/document/field.h"
#include "editor/model/document/wiring.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// Returns the first two inputs of the same type, preferring those with a value or a wire. Inputs
// that read the surface by default are left out: not every such default can be written as a wire at
// another input.
std::vector<const Port*> twins(const NodeType& type, const Node& node) {
    const auto counts = [](const Port& port) {
        return port.is_value() && port.default_kind != Port::Default::surface;
    };
    for (const Port& first : type.ports) {
        if (!counts(first)) continue;
        std::vector<const Port*> same;
        for (const Port& port : type.ports)
            if (counts(port) && port.type == first.type) same.push_back(&port);
        if (same.size() < 2) continue;
        std::stable_partition(same.begin(), same.end(),
                              [&](const Port* port) { return node.find(port->name); });
        same.resize(2);
        return same;
    }
    return {};
}

json::Value default_of(const Port& port) {
    const auto lanes = static_cast<size_t>(lanes_of_field(port));
    if (lanes == 1) return json::Value::number(port.default_value[0]);
    std::vector<json::Value> items;
    for (size_t i = 0; i < lanes; ++i)
        items.push_back(json::Value::number(port.default_value[i]));
    return json::Value::array(items);
}

bool same_default(const Port& a, const Port& b) {
    return a.default_kind == b.default_kind && a.default_value == b.default_value;
}

// Moves the input at port `from` of the old node, or its default, to port `to`.
Document hand_on(const Document& document, const Node& old, const Port& from, const Port& to) {
    const Input* input = old.find(from.name);
    const Document bare = reset_value(document, old.id, to.name);
    if (input && input->kind == Input::Kind::link)
        return connect(bare, input->link, old.id, to.name);
    if (input) return set_value(bare, old.id, to.name, input->value);
    if (same_default(from, to)) return bare;
    return lanes_of_field(from) > 0 ? set_value(bare, old.id, to.name, default_of(from)) : bare;
}

}  // namespace

Document swap_inputs(const Model& model, const Document& document, const std::string& id) {
    const Node* node = document.find(id);
    const NodeType* type = model.type_of(id);
    if (!node || !type) return document;
    const std::vector<const Port*> ports = twins(*type, *node);
    Document result = document;
    for (size_t i = 0; i < ports.size(); ++i)
        result = hand_on(result, *node, *ports[i], *ports[(i + 1) % ports.size()]);
    return ports.empty() ? document : result;
}

}  // namespace wrinkle::editor
